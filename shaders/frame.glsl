// What every pass begins with: the frame's constants and the conventions of shared/frame.h as functions.
#ifndef UNGHOST_FRAME_GLSL
#define UNGHOST_FRAME_GLSL

#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "shared/frame.h"
#include "shared/bindings.h"

layout(set = 0, binding = FRAME_BINDING, scalar) uniform Frame { FrameConstants frame_constants; };
/// Read once, before anything branches: a software device reads a constant again in each branch that names it, which made
/// the light and motion passes a quarter slower.
FrameConstants frame = frame_constants;

/// From the camera through the middle of a pixel, as it was drawn (with jitter), to 1 m along the view axis.
vec3 view_ray(vec2 pixel) {
  vec2 ndc = (pixel - frame.jitter_px) * frame.inverse_size_px * 2 - 1;
  return vec3(ndc.x * frame.tangent.x, -ndc.y * frame.tangent.y, -1);
}

/// Metres along the view axis; infinite for the sky.
float linear_depth(float depth) { return frame.near_plane / depth; }

/// A depth and a tag in one number, so that whoever looks for the closest finds its tag, too. 16 bits of the depth's
/// significand are left: a millimetre at 65 m.
float with_tag(float depth, uint tag) { return uintBitsToFloat((floatBitsToUint(depth) & ~0xffu) | tag); }
float without_tag(float depth) { return with_tag(depth, 0); }
uint tag_of(float tagged_depth) { return floatBitsToUint(tagged_depth) & 0xffu; }

/// Octahedral: a direction as two numbers in [-1, 1].
vec2 octahedral_from_direction(vec3 d) {
  d /= abs(d.x) + abs(d.y) + abs(d.z);
  vec2 folded = (1 - abs(d.yx)) * vec2(d.x >= 0 ? 1 : -1, d.y >= 0 ? 1 : -1);
  return d.z >= 0 ? d.xy : folded;
}

vec3 direction_from_octahedral(vec2 o) {
  vec3 d = vec3(o, 1 - abs(o.x) - abs(o.y));
  float under = max(-d.z, 0);
  d.xy += vec2(d.x >= 0 ? -under : under, d.y >= 0 ? -under : under);
  return normalize(d);
}

#endif
