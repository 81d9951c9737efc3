// What one pixel becomes, once its neighbourhood is known. The naive and the fast resolve share this; they differ in how
// they come to the neighbourhood, to the pixel that speaks for it, and to the volume that bounds its history.
#ifndef UNGHOST_TAA_PIXEL_GLSL
#define UNGHOST_TAA_PIXEL_GLSL

#include "history.glsl"
#include "taa_colour.glsl"
#include "taa_rectify.glsl"

const uint filled_flags =
    reject_tag | reject_near_moving | reject_velocity | reject_depth | reject_object | reject_moved_object;
bool needs_blurred() { return fill == fill_blurred && rejects(filled_flags); }
bool tests_tags() { return rejects(reject_tag) && reads_tags; }
/// The history's alpha has one place: of a keyed row, tags go with the objects.
bool keeps_tags_apart() { return tests_tags() && keyed(); }
bool reads_alpha() { return tests_tags() || keyed(); }
bool needs_volume() { return rectify != rectify_none; }
bool counts() { return writes_to(TAA_WRITES_COUNT); }
/// Of the count that goes with a key; blend_counting has one of its own, which goes further.
bool takes_age() { return keyed() && blend != blend_counting; }
float most_frames() { return keeps == keeps_input ? 2 : takes_age() ? KEPT_AGES : 1024; }

/// The reprojection of a pixel.
struct Reprojected {
  vec2 motion, at;
  bool known;        // where the surface was
  bool inside;       // the picture
  vec3 found;        // the history there, linear, not negative
  bool number;       // which it was
  vec4 alphas;       // of the four pixels there
  float count;       // frames that it holds
  float lightness;   // of what fell on it
  uint causes;       // for which some of it was given up already
};

/// All but what the history holds there.
Reprojected reproject(ivec2 pixel, ivec2 speaker) {
  Reprojected r = Reprojected(motion_at(speaker), vec2(0), false, false, vec3(0), false, vec4(0), 0, 1, 0);
  r.known = all(lessThan(abs(r.motion), vec2(MOTION_UNKNOWN / 2)));  // nor where it is not a number
  r.at = vec2(pixel) + 0.5 + (r.known ? r.motion : vec2(0));
  r.inside = all(greaterThanEqual(r.at, vec2(0))) && all(lessThanEqual(r.at, frame.size_px));
  if (counts()) r.count = read_count(r.at);
  return r;
}

/// `found` as the filter gives it, which may overshoot below 0.
void take_history(inout Reprojected r, vec3 found) {
  r.number = !(any(isnan(found)) || any(isinf(found)));
  r.found = max(found, vec3(0));
}

/// Whether there is a history to be used: one that is not a number is none.
bool usable(Reprojected r) {
  return r.known && r.number && (r.inside || !rejects(reject_off_screen));
}

/// What the keys of a pixel's 3x3 say of it.
struct Around {
  uint own;           // its key
  bool mixed;         // another object, or depth, within
  bool moving;        // some of them moves, or did
  float mean;         // lightness
};

/// What speaks for a pixel. Its depth and tag are 0 where no test asks for them, key and what is around where none is kept.
struct Speaker {
  ivec2 at;
  float depth;
  uint tag;
  uint key;
  Around around;
};
const Around nothing_around = Around(0, false, false, 0);

bool may_move(uint id) { return id - 1 < MOVING_IDS; }

/// Whether the closer of two keys lies across an edge of depth, or of an object. The ground is closer than what stands on
/// it: that is no edge of what may move.
bool is_edge(uint own, uint closest) {
  bool other = ((own ^ closest) & KEY_ID) != 0, ground = may_move(id_of_key(own)) && !may_move(id_of_key(closest));
  return rank_of_key(closest) > rank_of_key(own) &&
         ((other && !ground) || depth_of_key(closest) > 1.2 * depth_of_key(own));
}

/// Of nine steps of light.
float mean_lightness(uint sum) { return float(sum) * (1.0 / (9 * KEY_LIGHT_STEPS)); }

/// Whether no cause is known by which the history could be wrong, and it may be so: what a surface mirrors, and edges of
/// what moves.
bool is_unknown(Speaker speaker) {
  bool glossy = ((speaker.key | speaker.around.own) & KEY_GLOSSY) != 0;
  return glossy || (speaker.around.mixed && speaker.around.moving);
}

/// From rest to what counts as fast.
float fast_share(Reprojected r) { return r.known ? smoothstep(0, push.fast_px, length(r.motion)) : 1; }

bool centres_input() { return input_frame == input_centred; }

/// Weights of three pixels in a row of a Gaussian about where the middle one would be without jitter. Samples that are to be
/// averaged over many frames lie beside it in turns; where few are, that is noise.
vec3 centred_weights(float jitter_px) {
  vec3 off = (vec3(-1, 0, 1) - jitter_px) / push.centred_px;
  vec3 weights = exp(-0.5 * off * off);
  return weights / (weights.x + weights.y + weights.z);
}

/// What a pixel becomes, and why.
struct Resolve {
  vec3 colour;
  float weight;  // of the current frame
  float count;   // frames that it holds
  float lightness;  // of what falls on it
  uint causes;   // of the history's rejection, in whole or in part: bits of `reject`
  float rectified;  // how far the history was moved: 1 by a tenth of itself or more
  vec3 history;     // as it was used
  vec3 found, bounded;  // for the probe: as it was read, linear; rectified, in the working space
  vec3 mixed_in;     // of the frame
  bool has_history;
};

Resolve without_history(vec3 centre, Speaker speaker) {
  float lightness = keyed() ? lightness_of_key(speaker.around.own) : 0;
  return Resolve(centre, 1, 1, lightness, 0, 0, centre, vec3(0), vec3(0), centre, false);
}

bool asks_for_depth() { return rejects(reject_near_moving); }

/// How much each of the four pixels that a history comes from weighs there: x first, then y.
vec4 four_shares(vec2 at) {
  vec2 f = fract(at - 0.5);
  return vec4((1 - f.x) * (1 - f.y), f.x * (1 - f.y), (1 - f.x) * f.y, f.x * f.y);
}
const vec4 least_share = vec4(1.0 / 16);  // less is not worth giving up a history for

bool tag_differs(uint now, Reprojected r) {
  return any(bvec4(uvec4(greaterThan(four_shares(r.at), least_share)) & uvec4(notEqual(r.alphas, vec4(now)))));
}

/// Of the bits in `mask`.
bool object_differs(uint now, uint mask, vec2 at) {
  ivec2 corner = ivec2(floor(at - 0.5));
  uvec4 before;
  for (int i = 0; i < 4; ++i)
    before[i] = fetch(previous_object_map, inside(corner + ivec2(i & 1, i >> 1))).r & mask;
  return any(bvec4(uvec4(greaterThan(four_shares(at), least_share)) & uvec4(notEqual(before, uvec4(now & mask)))));
}

/// Another object of which either moves or did, or any other where the picture moves. Nothing may bound the history here,
/// so that far less than another test overlooks would stay.
const float least_leak = 1.0 / 256;
bool moved_object_differs(uint key, Reprojected r) {
  uint now = id_of_key(key);
  bool moves = dot(r.motion, r.motion) > push.motion_threshold_px * push.motion_threshold_px;
  uint movers = moves || (push.moved_ids >> now & 1) != 0 ? ~0u : push.moved_ids;
  vec4 shares = four_shares(r.at);
  bool differs = false;
  for (int i = 0; i < 4; ++i) {
    uint before = kept_of_half(r.alphas[i]).id;
    differs = differs || (before != now && (movers >> before & 1) != 0 && shares[i] > least_leak);
  }
  return differs;
}

/// Whether none of the four pixels that the history comes from was as far away as this surface was; the sky is as far as
/// the sky alone.
bool depth_differs(float expected, vec2 at) {
  ivec2 corner = ivec2(floor(at - 0.5));
  vec4 shares = four_shares(at);
  bool found = false;
  for (int i = 0; i < 4; ++i) {
    float before = fetch(previous_depth_map, inside(corner + ivec2(i & 1, i >> 1))).r;
    bool as_far = isinf(expected) || isinf(before) ? before == expected
                                                   : abs(before - expected) <= push.depth_share * expected;
    found = found || (as_far && shares[i] > least_share[i]);
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

Rejection rejection(Reprojected r, Speaker speaker) {
  Rejection j = Rejection(0, 0, false, r.causes);
  if (tests_tags() && (keeps_tags_apart() ? object_differs(speaker.tag << OBJECT_TAG_SHIFT, ~OBJECT_NODE, r.at)
                                          : tag_differs(speaker.tag, r)))
    j.share = 1, j.causes |= reject_tag;
  if (rejects(reject_object) && object_differs(object_at(speaker.at), OBJECT_NODE, r.at))
    j.share = 1, j.causes |= reject_object;
  if (rejects(reject_moved_object) && moved_object_differs(speaker.key, r)) j.share = 1, j.causes |= reject_moved_object;
  if (rejects(reject_depth) && depth_differs(fetch(expected_depth_map, speaker.at).r, r.at))
    j.share = 1, j.causes |= reject_depth;
  if (rejects(reject_near_moving)) {
    float nearness = clamp((push.far_m - linear_depth(speaker.depth)) / (push.far_m - push.near_m), 0, 1);
    bool moves = dot(r.motion, r.motion) > push.motion_threshold_px * push.motion_threshold_px;
    float share = speaker.tag == 0 && moves ? nearness * nearness * (3 - 2 * nearness) : 0;
    if (share > j.share) j.causes |= reject_near_moving;
    j.share = max(j.share, share);
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

uint class_of(Speaker speaker) {
  bool glossy = ((speaker.key | speaker.around.own) & KEY_GLOSSY) != 0;
  return (glossy ? TAA_CLASS_GLOSSY : 0) | (speaker.around.mixed ? TAA_CLASS_MIXED : 0) |
         (speaker.around.moving ? TAA_CLASS_MOVING : 0) | (is_unknown(speaker) ? TAA_CLASS_UNKNOWN : 0);
}

/// What a keyed history says of itself, in place of its count.
void take_kept(inout Reprojected r) {
  vec4 shares = four_shares(r.at);
  r.lightness = 0;
  float most = 0;
  for (int i = 0; i < 4; ++i) {
    Kept kept = kept_of_half(r.alphas[i]);
    r.lightness += shares[i] * kept.lightness;
    if (takes_age() && shares[i] > most) most = shares[i], r.count = kept.age;
  }
}

/// Where light may have changed, a history whose light was not between the pixel's and the mean of those around is lit anew,
/// as a surface that does not shine by itself would be.
void follow_light(inout Reprojected r, Around around) {
  if ((around.own & KEY_LIGHT_CHANGES) == 0) return;
  const float most_change = 16;
  float now = lightness_of_key(around.own);
  float bounded = clamp(r.lightness, min(now, around.mean), max(now, around.mean));
  if (bounded == r.lightness) return;
  float change = clamp(light_of(bounded) / max(light_of(r.lightness), 1e-6), 1 / most_change, most_change);
  r.found *= change;
  r.lightness = bounded;
  r.count *= min(change, 1 / change);
  r.causes |= reject_visibility;
}

/// The weight of the current frame where nothing is rejected.
float speed_weight(Reprojected r, Speaker speaker) {
  float weight = mix(push.alpha, push.fast_alpha, fast_share(r)) + push.zoom_weight * zoom_of(speaker.key);
  if (speaker.around.mixed && speaker.around.moving) weight = max(weight, push.mixed_alpha);
  return clamp(max(weight, r.count < most_frames() ? 1 / (r.count + 1) : 0), 0, 1);
}

float blend_weight(Reprojected r, Speaker speaker, float rectified) {
  switch (blend) {
  case blend_counting: return max(push.alpha, 1 / (r.count + 1));
  case blend_speed: return speed_weight(r, speaker);
  case blend_attenuated: return push.alpha * (1 - 0.75 * rectified);
  default: return push.alpha;
  }
}

/// Of the history as it is bounded in the working space, and of a colour with this weight.
vec3 average(Reprojected r, vec3 bounded, vec3 colour, float weight) {
  if (weighting != weighting_inverse_luminance) return from_working(mix(bounded, to_working(colour), weight));
  // The same average by its weights: 1 - L of a mean of c / (1 + L) has lost all but a few bits where L is large. A history
  // that its volume left alone is what was read, for the same reason.
  const float resolution = 2e-7;
  bool kept = all(lessThanEqual(abs(bounded - to_working(r.found)), vec3(resolution)));
  vec3 history = kept ? r.found : from_working(bounded);
  float a = weight / (1 + luminance(colour)), b = (1 - weight) / (1 + luminance(history));
  return (a * colour + b * history) / (a + b);
}

/// `bounded` is the history in the working space after rectification, `moved` how far it was moved.
Resolve resolve(Reprojected r, Speaker speaker, Rejection j, vec3 centre, vec3 blurred, vec3 bounded, float moved) {
  Resolve result = without_history(centre, speaker);
  if (!usable(r)) {
    result.causes = reject_off_screen;
    return result;
  }
  result.causes = j.causes;
  result.rectified = moved;
  if (writes_to(TAA_WRITES_PROBE)) result.mixed_in = centre;
  if (writes_to(TAA_WRITES_PROBE)) result.found = r.found, result.bounded = bounded, result.has_history = true;
  if (writes_to(TAA_WRITES_HISTORY)) result.history = from_working(bounded);
  if (j.whole) return result;
  float weight = mix(blend_weight(r, speaker, moved), 1, j.share);
  vec3 colour = needs_blurred() ? mix(centre, blurred, j.share) : centre;
  result.colour = weight >= 1 ? colour : average(r, bounded, colour, weight);
  if (rejects(reject_velocity)) result.colour = mix(result.colour, blurred, j.drawn);
  result.weight = mix(weight, 1, j.drawn);
  result.count = result.weight >= 1 ? 1 : min(r.count + 1, most_frames());
  if (keyed()) result.lightness = mix(r.lightness, result.lightness, result.weight);
  return result;
}

/// A half float next to the colour, up or down in turns that are proportional to how near it is. Rounded to the nearest, an
/// average stops as soon as its step is less than half a unit: 2.5% short at a weight of .02; cut off, as a software device
/// stores it, it drifts down. The turns are a sequence of the golden ratio a pixel (a set of low discrepancy: Roberts 2018),
/// whose mean over time is nearer to the colour than that of chance. None is so near to either end that what arithmetic
/// leaves beside a half float would take it away: a history that stays, stays as it is to the bit.
const uint unit = 8192, arithmetic = 16;  // of a float's significand: of a half float, and that may be wrong
uint turn_of(ivec2 pixel) {  // of all channels: a grey stays grey
  uint seed = uint(pixel.x) * 3242174889u + uint(pixel.y) * 2447445413u + push.frame * 2654435769u;
  return clamp(seed >> 19, arithmetic, unit - arithmetic);
}
vec3 rounded(vec3 colour, ivec2 pixel) {
  uvec3 bits = floatBitsToUint(min(colour, vec3(65504)));
  return uintBitsToFloat((bits + turn_of(pixel)) & ~(unit - 1));
}
vec3 stored(vec3 colour, ivec2 pixel) {
  return store == store_dithered ? rounded(colour, pixel) : clamp(colour, vec3(0), vec3(65504));
}

/// Rounded up or down in the same turns.
uint light_step(float lightness, ivec2 pixel) {
  return uint(lightness * KEY_LIGHT_STEPS + float(turn_of(pixel)) / unit);
}

float reasons_of(Speaker speaker, Resolve r) { return r.causes | class_of(speaker) << TAA_CLASS_SHIFT; }

void write_probe(ivec2 pixel, Speaker speaker, Resolve r) {
  if (any(notEqual(pixel, push.probe_px))) return;
  ivec2 off = speaker.at - pixel + 1;
  imageStore(probe_out, ivec2(TAA_PROBE_FOUND, 0), vec4(r.found, 3 * off.y + off.x));
  imageStore(probe_out, ivec2(TAA_PROBE_BOUNDED, 0), vec4(r.bounded, r.weight));
  imageStore(probe_out, ivec2(TAA_PROBE_WHY, 0), vec4(r.rectified, reasons_of(speaker, r), r.count, r.has_history));
  imageStore(probe_out, ivec2(TAA_PROBE_INPUT, 0), vec4(r.mixed_in, 1));
}

/// Writes all that is asked for. The tag goes with the history, and costs no image of its own.
void write_pixel(ivec2 pixel, Speaker speaker, vec3 centre, Resolve r) {
  float tag = tests_tags() ? speaker.tag : 0;
  if (keyed()) tag = kept_as_half(id_of_key(speaker.key), r.count, light_step(r.lightness, pixel));
  imageStore(colour_out, pixel, vec4(stored(r.colour, pixel), tag));
  if (keeps == keeps_input) imageStore(input_out, pixel, vec4(min(centre, vec3(65504)), tag));
  if (writes_to(TAA_WRITES_COUNT)) imageStore(count_out, pixel, vec4(r.count));
  if (writes_to(TAA_WRITES_MOTION)) imageStore(motion_out, pixel, vec4(motion_at(speaker.at), 0, 0));
  if (writes_to(TAA_WRITES_DEPTH)) imageStore(depth_out, pixel, vec4(linear_depth(depth_at(speaker.at))));
  if (writes_to(TAA_WRITES_OBJECT))
    imageStore(object_out, pixel,
               uvec4(object_at(speaker.at) | (keeps_tags_apart() ? speaker.tag << OBJECT_TAG_SHIFT : 0)));
  if (writes_to(TAA_WRITES_WHY))
    imageStore(why_out, pixel, vec4(r.weight, r.rectified, reasons_of(speaker, r), r.count));
  if (writes_to(TAA_WRITES_HISTORY)) imageStore(history_out, pixel, vec4(r.history, 1));
  if (writes_to(TAA_WRITES_PROBE)) write_probe(pixel, speaker, r);
}

#endif
