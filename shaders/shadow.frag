#version 460
#extension GL_GOOGLE_include_directive : require
#define UNGHOST_FRAGMENT
#include "draw.glsl"

layout(location = 0) in vec4 in_uv;
layout(location = 1) in float in_alpha;

void main() {
  float alpha = draw.material.base_colour.a * in_alpha;
  if (has_texture(TEXTURE_BASE_COLOUR)) alpha *= texture(base_colour_map, uv_of(TEXTURE_BASE_COLOUR, in_uv.xy, in_uv.zw)).a;
  if (alpha < draw.material.alpha_cutoff) discard;
}
