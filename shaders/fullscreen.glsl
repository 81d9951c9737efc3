// A full-screen pass: one invocation a pixel. `pixel_or_return` is the first line of its main.
#ifndef UNGHOST_FULLSCREEN_GLSL
#define UNGHOST_FULLSCREEN_GLSL

#include "shared/workgroup.h"

layout(local_size_x = WORKGROUP_WIDTH, local_size_y = WORKGROUP_HEIGHT) in;

#define pixel_or_return(pixel)                                                                               \
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);                                                       \
  if (any(greaterThanEqual(pixel, ivec2(frame.size_px)))) return

#endif
