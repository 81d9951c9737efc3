#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "fullscreen.glsl"
#include "shared/taa_key.h"

layout(constant_id = 0) const bool objects_moved = false;
layout(constant_id = 1) const bool keeps_previous_depth = false;
layout(constant_id = 2) const bool keeps_depth = false;
layout(constant_id = 3) const bool has_surfaces = false;
layout(constant_id = 4) const bool has_tags = false;
layout(constant_id = 5) const bool keeps_key = false;
layout(constant_id = 6) const bool has_irradiance = false;

layout(set = 0, binding = MOTION_DEPTH) uniform texture2D depth_map;
layout(set = 0, binding = MOTION_TAG) uniform utexture2D tag_map;
layout(set = 0, binding = MOTION_OF_OBJECTS, rgba32f) uniform readonly image2D object_motion;
layout(set = 0, binding = MOTION_OBJECT, r32ui) uniform readonly uimage2D object_map;
layout(set = 0, binding = MOTION_IRRADIANCE, r8ui) uniform readonly uimage2D irradiance_map;
layout(set = 0, binding = MOTION_OUT, rg32f) uniform writeonly image2D motion_out;
layout(set = 0, binding = MOTION_PREVIOUS_DEPTH_OUT, r32f) uniform writeonly image2D previous_depth_out;
layout(set = 0, binding = MOTION_DEPTH_OUT, r32f) uniform writeonly image2D depth_out;
layout(set = 0, binding = MOTION_KEY_OUT, r32ui) uniform writeonly uimage2D key_out;

/// Motion of what rests, in pixels, and where it was along last frame's view axis. Written as differences from this
/// frame, so that a camera at rest gives exactly 0.
vec3 motion_of_world(vec2 pixel, float depth) {
  vec3 ray = view_ray(pixel);
  float inverse_distance = depth / frame.near_plane;  // 0 for the sky: it turns, and does not shift
  vec3 change = frame.reprojection_turn * ray + frame.reprojection_shift * inverse_distance;
  float along = 1 - change.z;
  if (along <= 0) return vec3(MOTION_UNKNOWN, MOTION_UNKNOWN, 0);
  vec2 shift = (change.xy + ray.xy * change.z) / frame.tangent + frame.previous_over_tangent * (ray.xy + change.xy);
  vec2 ndc = shift / along;
  return vec3(vec2(ndc.x, -ndc.y) * 0.5 * frame.size_px, along / inverse_distance);
}

void main() {
  pixel_or_return(pixel);
  float depth = has_surfaces ? texelFetch(depth_map, pixel, 0).r : 0;
  vec3 motion = motion_of_world(vec2(pixel) + 0.5, depth);
  bool moved = false;
  if (objects_moved) {
    vec4 of_object = imageLoad(object_motion, pixel);
    moved = of_object.w > 0;
    if (moved) motion = of_object.xyz;
  }
  imageStore(motion_out, pixel, vec4(motion.xy, 0, 0));
  if (keeps_previous_depth) imageStore(previous_depth_out, pixel, vec4(motion.z, 0, 0, 0));
  if (keeps_depth) {
    uint tag = has_tags ? texelFetch(tag_map, pixel, 0).r : 0;
    imageStore(depth_out, pixel, vec4(with_tag(depth, tag), 0, 0, 0));
  }
  if (keeps_key) {
    uint object = has_surfaces ? imageLoad(object_map, pixel).r : 0;
    if (frame.mirrors_change == 0) object &= ~OBJECT_GLOSSY;
    uint light = has_irradiance ? imageLoad(irradiance_map, pixel).r : light_word(1, false);
    if (has_irradiance && moved) light |= LIGHT_CHANGES;  // it came to other light
    float zoom = depth > 0 ? motion.z * (depth / frame.near_plane) - 1 : 0;
    imageStore(key_out, pixel, uvec4(key_of(depth, object, light, zoom)));
  }
}
