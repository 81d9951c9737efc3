// The temporal resolve. Which answer a mode gives to each question is a specialization constant, so that what it does
// not use is not in its pipeline; how much is a push constant.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "frame.glsl"
#include "fullscreen.glsl"
#include "history.glsl"
#include "shared/taa.h"

layout(constant_id = 0) const uint dilation = 0;
layout(constant_id = 1) const uint history_filter = 0;
layout(constant_id = 2) const uint rectify = 0;
layout(constant_id = 3) const uint reject = 0;
layout(constant_id = 4) const bool reads_tags = false;
layout(constant_id = 5) const bool keeps_tags = false;
layout(constant_id = 6) const bool says_why = false;
layout(constant_id = 7) const bool has_history = false;

layout(set = 0, binding = TAA_COLOUR) uniform texture2D colour_map;
layout(set = 0, binding = TAA_PREVIOUS) uniform texture2D history_map;
layout(set = 0, binding = TAA_DEPTH) uniform texture2D depth_map;
layout(set = 0, binding = TAA_MOTION) uniform texture2D motion_map;
layout(set = 0, binding = TAA_TAG) uniform utexture2D tag_map;
layout(set = 0, binding = TAA_PREVIOUS_TAG) uniform utexture2D previous_tag_map;
layout(set = 0, binding = TAA_OUT, rgba16f) uniform writeonly image2D history_out;
layout(set = 0, binding = TAA_TAG_OUT, r8ui) uniform writeonly uimage2D tag_out;
layout(set = 0, binding = TAA_WHY_OUT, rgba8) uniform writeonly image2D why_out;
layout(push_constant, scalar) uniform Push { TaaPush push; };

/// The current frame around a pixel.
struct Neighbourhood {
  vec3 centre, low, high, blurred;
};

/// What is not a number ends here: it would spread through the history for ever.
vec3 finite(vec3 colour) {
  bvec3 bad = bvec3(uvec3(isnan(colour)) | uvec3(isinf(colour)));
  return mix(max(colour, vec3(0)), vec3(0), bad);
}

Neighbourhood gather(ivec2 pixel, ivec2 last) {
  Neighbourhood n = Neighbourhood(vec3(0), vec3(1e30), vec3(0), vec3(0));
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      vec3 colour = finite(texelFetch(colour_map, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).rgb);
      if (x == 0 && y == 0) n.centre = colour;
      n.low = min(n.low, colour);
      n.high = max(n.high, colour);
      n.blurred += colour * float((2 - abs(x)) * (2 - abs(y))) / 16;
    }
  return n;
}

/// The pixel whose motion, depth and tag speak for this one.
ivec2 dilated(ivec2 pixel, ivec2 last) {
  if (dilation == dilation_centre) return pixel;
  ivec2 closest = pixel;
  float depth = texelFetch(depth_map, pixel, 0).r;  // of equals the pixel itself
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      ivec2 at = clamp(pixel + ivec2(x, y), ivec2(0), last);
      float d = texelFetch(depth_map, at, 0).r;
      if (d > depth) closest = at, depth = d;
    }
  return closest;
}

vec3 read_history(vec2 at, ivec2 last) {
  switch (history_filter) {
  case history_catmull_rom: return catmull_rom(history_map, at, last);
  default: return bilinear(history_map, at, last);
  }
}

vec3 rectified(vec3 history, Neighbourhood n) {
  switch (rectify) {
  case rectify_box_clamp: return clamp(history, n.low, n.high);
  default: return history;
  }
}

/// Whether any of the four pixels that the history comes from, and weighs there, had another tag.
bool tag_differs(uint tag, vec2 at, ivec2 last) {
  const float least_weight = 1.0 / 16;
  vec2 texel = at - 0.5, f = fract(texel);
  ivec2 corner = ivec2(floor(texel));
  bool differs = false;
  for (int i = 0; i < 4; ++i) {
    ivec2 tap = ivec2(i & 1, i >> 1);
    vec2 share = mix(1 - f, f, vec2(tap));
    uint before = texelFetch(previous_tag_map, clamp(corner + tap, ivec2(0), last), 0).r;
    differs = differs || (share.x * share.y > least_weight && before != tag);
  }
  return differs;
}

/// A half float next to the colour, up or down by chance in proportion to how near it is; a half float stays itself.
/// Rounded to the nearest, an average stops as soon as its step is less than half a unit: 2.5% short at a weight of .02.
vec3 rounded(vec3 colour, ivec2 pixel) {
  uvec3 seed = uvec3(pixel, push.frame);  // PCG3D, Jarzynski and Olano 2020
  seed = seed * 1664525u + 1013904223u;
  seed.x += seed.y * seed.z, seed.y += seed.z * seed.x, seed.z += seed.x * seed.y;
  seed ^= seed >> 16;
  seed.x += seed.y * seed.z, seed.y += seed.z * seed.x, seed.z += seed.x * seed.y;
  vec3 chance = vec3(seed >> 8) / 16777216.0;
  vec3 bounded = min(colour, vec3(65504));
  vec3 unit = exp2(floor(log2(max(bounded, vec3(6.2e-5)))) - 10);
  return min(floor(bounded / unit + chance) * unit, vec3(65504));
}

/// What a pixel becomes, and why.
struct Resolve {
  vec3 colour;
  float weight;  // of the current frame
  bool rectified, tag_rejected, near_moving;
};

Resolve resolve(ivec2 pixel, ivec2 speaker, ivec2 last, uint tag) {
  Neighbourhood n = gather(pixel, last);
  Resolve r = Resolve(n.centre, 1, false, false, false);
  vec2 motion = texelFetch(motion_map, speaker, 0).xy;
  if (!all(lessThan(abs(motion), vec2(MOTION_UNKNOWN / 2)))) return r;  // nor where it is not a number
  vec2 at = vec2(pixel) + 0.5 + motion;
  bool inside = all(greaterThanEqual(at, vec2(0))) && all(lessThanEqual(at, frame.size_px));
  if ((reject & reject_off_screen) != 0 && !inside) return r;
  vec3 found = read_history(at, last);
  if (any(isnan(found)) || any(isinf(found))) return r;
  vec3 history = rectified(found, n);
  r.rectified = any(greaterThan(abs(history - found), 0.01 * found + 0.001));  // what can be seen
  r.weight = push.alpha;
  if ((reject & reject_tag) != 0 && keeps_tags) {
    r.tag_rejected = tag_differs(tag, at, last);
    if (r.tag_rejected) {
      r.weight = 1;
      r.colour = n.blurred;
    }
  }
  if ((reject & reject_near_moving) != 0) {
    float distance_m = linear_depth(texelFetch(depth_map, speaker, 0).r);
    r.near_moving =
        !r.tag_rejected && tag == 0 && length(motion) > push.motion_threshold_px && distance_m < push.far_m;
    if (r.near_moving) {
      float share = 1 - smoothstep(push.near_m, push.far_m, distance_m);
      r.weight = mix(r.weight, 1, share);
      r.colour = mix(r.colour, n.blurred, share);
    }
  }
  r.colour = mix(history, r.colour, r.weight);
  return r;
}

void main() {
  pixel_or_return(pixel);
  ivec2 last = ivec2(frame.size_px) - 1;
  ivec2 speaker = has_history || keeps_tags ? dilated(pixel, last) : pixel;
  uint tag = reads_tags ? texelFetch(tag_map, speaker, 0).r : 0;
  Resolve r = Resolve(vec3(0), 1, false, false, false);
  if (has_history) r = resolve(pixel, speaker, last, tag);
  else r.colour = finite(texelFetch(colour_map, pixel, 0).rgb);

  vec3 colour = rounded(r.colour, pixel);
  imageStore(history_out, pixel, vec4(colour, 1));
  if (keeps_tags) imageStore(tag_out, pixel, uvec4(tag));
  if (says_why) imageStore(why_out, pixel, vec4(r.weight, r.rectified, r.tag_rejected, r.near_moving));
}
