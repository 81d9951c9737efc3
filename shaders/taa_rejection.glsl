// When the history of a pixel is given up.
#ifndef UNGHOST_TAA_REJECTION_GLSL
#define UNGHOST_TAA_REJECTION_GLSL

#include "taa_reprojection.glsl"

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
  if (rejects(reject_moved_object) && r.other_moved) j.share = 1, j.causes |= reject_moved_object;
  if (rejects(reject_depth) && depth_differs(fetch(expected_depth_map, speaker.at).r, r.at))
    j.share = 1, j.causes |= reject_depth;
  if (rejects(reject_near_moving)) {
    float nearness = clamp((push.far_m - linear_depth(speaker.depth)) / (push.far_m - push.near_m), 0, 1);
    float share = speaker.tag == 0 && moves(r) ? nearness * nearness * (3 - 2 * nearness) : 0;
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

#endif
