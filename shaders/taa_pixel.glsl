// What one pixel becomes, once its neighbourhood is known. The naive and the fast resolve share this; they differ in how
// they come to the neighbourhood, to the pixel that speaks for it, and to the volume that bounds its history.
#ifndef UNGHOST_TAA_PIXEL_GLSL
#define UNGHOST_TAA_PIXEL_GLSL

#include "history.glsl"
#include "taa_colour.glsl"
#include "taa_rectify.glsl"

const uint flags_of_neighbours = reject_tag | reject_near_moving | reject_velocity | reject_depth | reject_object;
bool needs_blurred() { return rejects(flags_of_neighbours); }
bool needs_volume() { return rectify != rectify_none; }
bool counts() { return blend == blend_counting || writes_to(TAA_WRITES_COUNT); }

/// The reprojection of a pixel.
struct Reprojected {
  vec2 motion, at;
  bool known;        // where the surface was
  bool inside;       // the picture
  vec3 found;        // the history there, linear
  float count;       // frames that it holds
};

/// All but what the history holds there.
Reprojected reproject(ivec2 pixel, ivec2 speaker) {
  Reprojected r = Reprojected(motion_at(speaker), vec2(0), false, false, vec3(0), 0);
  r.known = all(lessThan(abs(r.motion), vec2(MOTION_UNKNOWN / 2)));  // nor where it is not a number
  r.at = vec2(pixel) + 0.5 + (r.known ? r.motion : vec2(0));
  r.inside = all(greaterThanEqual(r.at, vec2(0))) && all(lessThanEqual(r.at, frame.size_px));
  if (counts()) r.count = read_count(r.at);
  return r;
}

/// Whether there is a history to be used: one that is not a number is none.
bool usable(Reprojected r) {
  bool number = !(any(isnan(r.found)) || any(isinf(r.found)));
  return r.known && number && (r.inside || !rejects(reject_off_screen));
}

/// What a pixel becomes, and why.
struct Resolve {
  vec3 colour;
  float weight;  // of the current frame
  float count;   // frames that it holds
  uint causes;   // of the history's rejection, in whole or in part: bits of `reject`
  float rectified;  // how far the history was moved: 1 by a tenth of itself or more
  vec3 history;     // as it was used
};

/// Whether any of the four pixels that the history comes from, and weighs there, had another one.
#define ANY_OF_FOUR_DIFFERS(name, map)                                                                       \
  bool name(uint now, vec2 at) {                                                                             \
    const float least_weight = 1.0 / 16;                                                                     \
    vec2 texel = at - 0.5, f = fract(texel);                                                                 \
    ivec2 corner = ivec2(floor(texel));                                                                      \
    bool differs = false;                                                                                    \
    for (int i = 0; i < 4; ++i) {                                                                            \
      ivec2 tap = ivec2(i & 1, i >> 1);                                                                      \
      vec2 share = mix(1 - f, f, vec2(tap));                                                                 \
      uint before = fetch(map, inside(corner + tap)).r;                                                      \
      differs = differs || (share.x * share.y > least_weight && before != now);                              \
    }                                                                                                        \
    return differs;                                                                                          \
  }
ANY_OF_FOUR_DIFFERS(tag_differs, previous_tag_map)
ANY_OF_FOUR_DIFFERS(object_differs, previous_object_map)

/// Whether none of the four pixels that the history comes from was as far away as this surface was.
bool depth_differs(float expected, vec2 at) {
  ivec2 corner = ivec2(floor(at - 0.5));
  bool found = isinf(expected);  // the sky is behind whatever was there
  for (int i = 0; i < 4; ++i) {
    float before = fetch(previous_depth_map, inside(corner + ivec2(i & 1, i >> 1))).r;
    found = found || abs(before - expected) <= push.depth_share * expected;
  }
  return !found;
}

/// How much of the history is given up, and for what colour.
struct Rejection {
  float share;        // of the weight and of the colour, towards 1 and the blurred
  float drawn;        // of the result towards the blurred (velocity)
  bool whole;         // the current colour alone
  uint causes;
};

Rejection rejection(Reprojected r, ivec2 speaker, uint tag) {
  Rejection j = Rejection(0, 0, false, 0);
  if (rejects(reject_tag) && reads_tags && tag_differs(tag, r.at)) j.share = 1, j.causes |= reject_tag;
  if (rejects(reject_object) && object_differs(object_at(speaker), r.at)) j.share = 1, j.causes |= reject_object;
  if (rejects(reject_depth) && depth_differs(fetch(expected_depth_map, speaker).r, r.at))
    j.share = 1, j.causes |= reject_depth;
  if (rejects(reject_near_moving)) {
    float distance_m = linear_depth(depth_at(speaker));
    if (j.share == 0 && tag == 0 && length(r.motion) > push.motion_threshold_px && distance_m < push.far_m) {
      j.share = 1 - smoothstep(push.near_m, push.far_m, distance_m);
      j.causes |= reject_near_moving;
    }
  }
  if (rejects(reject_velocity | reject_motion_length | reject_speed)) {
    vec2 before = fetch(previous_motion_map, inside(ivec2(floor(r.at)))).xy;
    float speed = length(r.motion), speed_before = length(before);
    if (rejects(reject_velocity)) {
      float difference = length((before - r.motion) * frame.inverse_size_px);
      j.drawn = clamp((difference - push.velocity_min) * push.velocity_slope, 0, 1);
      if (j.drawn > 0) j.causes |= reject_velocity;
    }
    bool lengths_differ = rejects(reject_motion_length) && abs(speed - speed_before) > push.motion_length_px;
    bool too_fast = rejects(reject_speed) && max(speed, speed_before) > push.speed_px;
    if (lengths_differ) j.causes |= reject_motion_length;
    if (too_fast) j.causes |= reject_speed;
    j.whole = lengths_differ || too_fast;
  }
  return j;
}

/// The weight of the current frame where nothing is rejected.
float blend_weight(float count, float rectified) {
  switch (blend) {
  case blend_counting: return max(push.alpha, 1 / (count + 1));
  case blend_attenuated: return push.alpha * (1 - 0.75 * rectified);
  default: return push.alpha;
  }
}

/// `bounded` is the history in the working space after rectification, `share` how far it was moved.
Resolve resolve(Reprojected r, Rejection j, vec3 centre, vec3 blurred, vec3 bounded, float moved) {
  Resolve result = Resolve(centre, 1, 1, 0, 0, centre);
  if (!usable(r)) {
    result.causes = reject_off_screen;
    return result;
  }
  result.causes = j.causes;
  result.rectified = moved;
  if (writes_to(TAA_WRITES_HISTORY)) result.history = from_working(bounded);
  if (j.whole) return result;
  float weight = mix(blend_weight(r.count, moved), 1, j.share);
  vec3 colour = needs_blurred() ? mix(centre, blurred, j.share) : centre;
  result.colour = weight >= 1 ? colour : from_working(mix(bounded, to_working(colour), weight));
  if (rejects(reject_velocity)) result.colour = mix(result.colour, blurred, j.drawn);
  result.weight = mix(weight, 1, j.drawn);
  result.count = result.weight >= 1 ? 1 : min(r.count + 1, 1024);
  return result;
}

/// A half float next to the colour, up or down in turns that are proportional to how near it is; a half float stays
/// itself. Rounded to the nearest, an average stops as soon as its step is less than half a unit: 2.5% short at a weight
/// of .02. The turns are a sequence of the golden ratio a pixel (a set of low discrepancy: Roberts 2018), whose mean over
/// time is nearer to the colour than that of chance.
vec3 rounded(vec3 colour, ivec2 pixel) {
  uint seed = uint(pixel.x) * 3242174889u + uint(pixel.y) * 2447445413u + push.frame * 2654435769u;
  uvec3 turn = (uvec3(seed) + uvec3(0, 1431655765u, 2863311530u)) >> 19;  // 13 bits: what a half float lacks
  uvec3 bits = floatBitsToUint(clamp(colour, vec3(0), vec3(65504)));
  return min(uintBitsToFloat((bits + turn) & ~uvec3(0x1fff)), vec3(65504));
}

/// Writes all that is asked for.
void write_pixel(ivec2 pixel, ivec2 speaker, uint tag, vec3 centre, Resolve r) {
  vec4 result = vec4(rounded(r.colour, pixel), counts() ? r.count : 1);
  imageStore(colour_out, pixel, result);
  if (keeps == keeps_input) imageStore(input_out, pixel, vec4(min(centre, vec3(65504)), 1));
  if (writes_to(TAA_WRITES_TAG)) imageStore(tag_out, pixel, uvec4(tag));
  if (writes_to(TAA_WRITES_MOTION)) imageStore(motion_out, pixel, vec4(motion_at(speaker), 0, 0));
  if (writes_to(TAA_WRITES_DEPTH)) imageStore(depth_out, pixel, vec4(linear_depth(depth_at(pixel))));
  if (writes_to(TAA_WRITES_OBJECT)) imageStore(object_out, pixel, uvec4(object_at(speaker)));
  if (writes_to(TAA_WRITES_WHY))
    imageStore(why_out, pixel, vec4(r.weight, r.rectified, float(r.causes) / 255, r.count / 255));
  if (writes_to(TAA_WRITES_HISTORY)) imageStore(history_out, pixel, vec4(r.history, 1));
}

#endif
