// Luminance away from the mean of its 3x3 neighbours, colour kept (GDK sample). Black stays black.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "fullscreen.glsl"

layout(set = 0, binding = SHARPEN_COLOUR, rgba16f) uniform readonly image2D colour_map;
layout(set = 0, binding = SHARPEN_OUT, rgba16f) uniform writeonly image2D crisp_out;
layout(push_constant, scalar) uniform Push { float amount; };

void main() {
  pixel_or_return(pixel);
  ivec2 last = ivec2(frame.size_px) - 1;
  vec3 centre = imageLoad(colour_map, pixel).rgb;
  float mean = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      mean += luminance(imageLoad(colour_map, clamp(pixel + ivec2(x, y), ivec2(0), last)).rgb) / 9;
  float here = luminance(centre);
  float scale = here > 0 ? max(here + (here - mean) * amount, 0) / here : 1;
  imageStore(crisp_out, pixel, vec4(min(centre * scale, vec3(65504)), 1));
}
