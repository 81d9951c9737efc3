// Where a pixel was, and what of the history is read there.
#ifndef UNGHOST_TAA_REPROJECTION_GLSL
#define UNGHOST_TAA_REPROJECTION_GLSL

#include "history.glsl"
#include "taa_speaker.glsl"

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

/// From rest to what counts as fast.
float fast_share(Reprojected r) { return r.known ? smoothstep(0, push.fast_px, length(r.motion)) : 1; }

/// How much each of the four pixels that a history comes from weighs there: x first, then y.
vec4 four_shares(vec2 at) {
  vec2 f = fract(at - 0.5);
  return vec4((1 - f.x) * (1 - f.y), f.x * (1 - f.y), (1 - f.x) * f.y, f.x * f.y);
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

#endif
