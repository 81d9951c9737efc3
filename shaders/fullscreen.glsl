// A full-screen pass: one invocation a pixel. `pixel_or_return` is the first line of its main.
#ifndef UNGHOST_FULLSCREEN_GLSL
#define UNGHOST_FULLSCREEN_GLSL

#include "shared/workgroup.h"

#ifndef FULLSCREEN_WIDTH
#define FULLSCREEN_WIDTH WORKGROUP_WIDTH
#define FULLSCREEN_HEIGHT WORKGROUP_HEIGHT
#endif
layout(local_size_x = FULLSCREEN_WIDTH, local_size_y = FULLSCREEN_HEIGHT) in;

#define pixel_or_return(pixel)                                                                               \
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);                                                       \
  if (any(greaterThanEqual(pixel, ivec2(frame.size_px)))) return

#endif
