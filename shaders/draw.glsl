// What drawing geometry reads: the draw itself, and the textures of its material.
#ifndef UNGHOST_DRAW_GLSL
#define UNGHOST_DRAW_GLSL

#include "frame.glsl"

layout(constant_id = 0) const uint features = 0;
layout(constant_id = 1) const bool moved = false;

layout(set = 0, binding = DRAW_PREVIOUS, scalar) readonly buffer Previous { mat4x3 previous_eye_from_object[]; };
layout(set = 0, binding = DRAW_TEXTURE_PLACES, scalar) readonly buffer Places { TexturePlaces texture_places[]; };
layout(push_constant, scalar) uniform Push { DrawPush draw; };

#ifdef UNGHOST_FRAGMENT
layout(set = 1, binding = TEXTURE_BASE_COLOUR) uniform sampler2D base_colour_map;
layout(set = 1, binding = TEXTURE_METALLIC_ROUGHNESS) uniform sampler2D metallic_roughness_map;
layout(set = 1, binding = TEXTURE_NORMAL) uniform sampler2D normal_map;
layout(set = 1, binding = TEXTURE_OCCLUSION) uniform sampler2D occlusion_map;
layout(set = 1, binding = TEXTURE_EMISSIVE) uniform sampler2D emissive_map;
layout(set = 1, binding = TEXTURE_COAT) uniform sampler2D coat_map;
layout(set = 1, binding = TEXTURE_COAT_ROUGHNESS) uniform sampler2D coat_roughness_map;

bool has(uint feature) { return (features & feature) != 0; }
bool has_texture(uint i) { return (features >> i & 1) != 0; }

/// Where the texture would have been read without the jitter.
vec2 shifted(vec2 uv) {
  return has(SHIFTS_TEXTURES) ? uv + dFdx(uv) * frame.texture_jitter_px.x + dFdy(uv) * frame.texture_jitter_px.y : uv;
}

vec2 uv_of(uint i, vec2 uv0, vec2 uv1) {
  if (!has(HAS_TEXTURE_PLACES)) return shifted(uv0);
  vec2 uv = (texture_places[draw.material_index].uv_sets >> i & 1) != 0 ? uv1 : uv0;
  return shifted(texture_places[draw.material_index].uv_transforms[i] * vec3(uv, 1));
}

vec4 texel_of(sampler2D map, uint i, vec2 uv0, vec2 uv1) {
  vec2 uv = uv_of(i, uv0, uv1);
  return has(BIASES_TEXTURES) ? texture(map, uv, frame.mip_bias) : texture(map, uv);
}
#endif

#endif
