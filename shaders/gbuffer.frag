#version 460
#extension GL_GOOGLE_include_directive : require
#define UNGHOST_FRAGMENT
#include "draw.glsl"
#include "shared/taa_key.h"

layout(location = 0) in vec3 in_normal;
layout(location = 1) in vec4 in_tangent;
layout(location = 2) in vec4 in_uv;
layout(location = 3) in vec4 in_colour;
layout(location = 4) in vec3 in_previous_eye;

#ifdef WRITES_SHADING
layout(location = 0) out vec4 out_albedo;
layout(location = 1) out vec2 out_normal;
layout(location = 2) out vec4 out_material;
#endif
#ifdef WRITES_EMISSIVE
layout(location = GBUFFER_EMISSIVE) out vec3 out_emissive;
#endif
#ifdef WRITES_MOTION
layout(location = GBUFFER_MOTION) out vec4 out_motion;
#endif
#ifdef WRITES_OBJECT
layout(location = 5) out uint out_id;
#endif

// A mirror would need rays; and roughness 0 is taken: it marks a surface that light does not change.
const float least_roughness = 0.03;

/// Whether what is seen in it does not stay with the surface: a coat, or a lobe a few degrees wide.
bool mirrors(vec4 material) { return material.z >= 0.1 || (material.x > 0 && material.x <= 0.3); }

/// In the frame of the front, and turned over as a whole for the back.
vec3 shading_normal(float normal_scale) {
  vec3 n = normalize(in_normal), shading = n;
  vec3 t = in_tangent.xyz - n * dot(in_tangent.xyz, n);
  float length2 = dot(t, t);
  if (has_texture(TEXTURE_NORMAL) && length2 > 1e-12) {
    t *= inversesqrt(length2);
    vec3 b = cross(n, t) * in_tangent.w;
    vec3 mapped = texel_of(normal_map, TEXTURE_NORMAL, in_uv.xy, in_uv.zw).xyz * 2 - 1;
    mapped.xy *= normal_scale;
    shading = normalize(t * mapped.x + b * mapped.y + n * max(mapped.z, 1e-3));
  }
  return gl_FrontFacing ? shading : -shading;
}

/// Motion in pixels and last frame's depth.
vec3 motion_of_object() {
  vec4 before = frame.previous_clip_from_eye * vec4(in_previous_eye, 1);
  if (before.w <= 0) return vec3(MOTION_UNKNOWN, MOTION_UNKNOWN, 0);
  vec2 pixel_before = (before.xy / before.w * 0.5 + 0.5) * frame.size_px;
  return vec3(pixel_before - (gl_FragCoord.xy - frame.jitter_px), before.w);
}

void main() {
  const MaterialData m = draw.material;
  vec4 base = m.base_colour * in_colour;
  if (has_texture(TEXTURE_BASE_COLOUR)) base *= texel_of(base_colour_map, TEXTURE_BASE_COLOUR, in_uv.xy, in_uv.zw);
  if (has(HAS_ALPHA_MASK) && base.a < m.alpha_cutoff) discard;
#ifdef WRITES_SHADING
  vec2 roughness_metalness = vec2(m.roughness, m.metalness);
  if (has_texture(TEXTURE_METALLIC_ROUGHNESS))
    roughness_metalness *= texel_of(metallic_roughness_map, TEXTURE_METALLIC_ROUGHNESS, in_uv.xy, in_uv.zw).gb;
  float occlusion = 1;
  if (has_texture(TEXTURE_OCCLUSION))
    occlusion += m.occlusion_strength * (texel_of(occlusion_map, TEXTURE_OCCLUSION, in_uv.xy, in_uv.zw).r - 1);
  vec2 coat = vec2(m.coat, m.coat_roughness);
  if (has_texture(TEXTURE_COAT)) coat.x *= texel_of(coat_map, TEXTURE_COAT, in_uv.xy, in_uv.zw).r;
  if (has_texture(TEXTURE_COAT_ROUGHNESS)) coat.y *= texel_of(coat_roughness_map, TEXTURE_COAT_ROUGHNESS, in_uv.xy, in_uv.zw).g;

  out_albedo = vec4(sqrt(base.rgb), occlusion);
  out_normal = octahedral_from_direction(shading_normal(m.normal_scale));
  out_material = vec4(max(roughness_metalness.x, least_roughness), roughness_metalness.y, coat.x,
                      max(coat.y, least_roughness));
  if (has(IS_UNLIT)) out_material.x = 0;
#endif
#ifdef WRITES_EMISSIVE
  vec3 emissive = m.emissive;
  if (has_texture(TEXTURE_EMISSIVE)) emissive *= texel_of(emissive_map, TEXTURE_EMISSIVE, in_uv.xy, in_uv.zw).rgb;
  out_emissive = has(IS_UNLIT) ? base.rgb : emissive;
#endif
#ifdef WRITES_MOTION
  out_motion = moved ? vec4(motion_of_object(), 1) : vec4(0);
#endif
#ifdef WRITES_OBJECT
  out_id = draw.object_word;
#ifdef WRITES_SHADING
  if (mirrors(out_material)) out_id |= OBJECT_GLOSSY;
#endif
#endif
}
