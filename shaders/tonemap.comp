#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "fullscreen.glsl"
#include "shared/tonemap.h"

layout(set = 0, binding = TONEMAP_COLOUR) uniform texture2D colour_map;
layout(set = 0, binding = TONEMAP_OUT, rgba8) uniform writeonly image2D display_out;

void main() {
  pixel_or_return(pixel);
  vec3 colour = texelFetch(colour_map, pixel, 0).rgb;
  // the store may truncate instead of rounding; half a step more makes a rounding of that
  vec3 display = display_from_linear(colour * frame.exposure);
  imageStore(display_out, pixel, vec4(floor(display * 255 + 0.5) / 255 + 1e-4, 1));
}
