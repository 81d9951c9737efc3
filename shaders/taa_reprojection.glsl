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
  bool other_moved;  // something else was there, and moves or did
  uint causes;       // for which some of it was given up, lit anew, or is to be bounded
};

/// All but what the history holds there.
Reprojected reproject(ivec2 pixel, ivec2 speaker) {
  Reprojected r = Reprojected(motion_at(speaker), vec2(0), false, false, vec3(0), false, vec4(0), 0, 1, false, 0);
  r.known = all(lessThan(abs(r.motion), vec2(MOTION_UNKNOWN / 2)));  // nor where it is not a number
  r.at = vec2(pixel) + 0.5 + (r.known ? r.motion : vec2(0));
  r.inside = all(greaterThanEqual(r.at, vec2(0))) && all(lessThanEqual(r.at, frame.size_px));
  if (counts()) r.count = read_count(r.at);
  return r;
}

/// Catmull-Rom overshoots, below 0, too: not beyond the four nearest texels where that is asked for.
void take_history(inout Reprojected r, Filtered f) {
  const float largest = 3e38;
  r.number = abs(f.colour.x) + abs(f.colour.y) + abs(f.colour.z) < largest;
  r.found = ringing == ringing_clamped ? clamp(f.colour, f.low, f.high) : max(f.colour, vec3(0));
}

/// Whether there is a history to be used: one that is not a number is none.
bool usable(Reprojected r) {
  return r.known && r.number && (r.inside || !rejects(reject_off_screen));
}

/// From rest to what counts as fast. Where a surface was is not known: as fast as can be.
float fast_share(Reprojected r) { return r.known ? min(dot(r.motion, r.motion) * push.inverse_fast_squared, 1) : 1; }

/// How much of the frame about the pixel's middle goes into the average, of that and of its sample.
float centred_share(Reprojected r) { return mix(push.centred_rest, 1, fast_share(r)); }

/// Whether colours bound a history: any, or one that may be wrong though no cause gives it up. None is known of what a surface
/// mirrors, and of edges of what moves, or of any where the picture does; what was lit anew was so as if it were matt, and too
/// much light tells no change.
bool needs_bounds(Speaker speaker, Reprojected r) {
  bool edge_moves = speaker.around.mixed && (speaker.around.moving || any(notEqual(r.motion, vec2(0))));
  return where == where_everywhere || is_glossy(speaker) || edge_moves || (r.causes & reject_visibility) != 0;
}

/// How much each of the four pixels that a history comes from weighs there: x first, then y.
vec4 four_shares(vec2 at) {
  vec2 f = fract(at - 0.5);
  return vec4((1 - f.x) * (1 - f.y), f.x * (1 - f.y), (1 - f.x) * f.y, f.x * f.y);
}

/// Faster than what tests overlook.
bool moves(Reprojected r) { return dot(r.motion, r.motion) > push.motion_threshold_px * push.motion_threshold_px; }

/// What a keyed history says of itself, in place of its count; and whether it is of another object than `key`: in the least,
/// of which either moves or did; for the most, where the picture moves.
void take_kept(inout Reprojected r, uint key) {
  const float least_leak = 1.0 / 256;  // nothing may bound the history here: what other tests overlook would stay
  vec4 shares = four_shares(r.at);
  uint now = id_of_key(key), seen = 0;
  float light = 0, of_others = 0;
  for (int i = 0; i < 4; ++i) {
    Kept kept = kept_of_half(r.alphas[i]);
    light += shares[i] * kept.light_step;
    of_others += kept.id != now ? shares[i] : 0;
    seen |= shares[i] > least_leak ? 1u << kept.id : 0;
  }
  uint others = seen & ~(1u << now), movers = (push.moved_ids >> now & 1) != 0 ? ~0u : push.moved_ids;
  r.other_moved = (others & movers) != 0 || (of_others > 0.5 && moves(r));
  r.lightness = light * (1.0 / KEY_LIGHT_STEPS);
  if (!takes_age()) return;
  bvec2 later = greaterThan(fract(r.at - 0.5), vec2(0.5));  // the nearest, which weighs most
  r.count = kept_of_half(later.y ? (later.x ? r.alphas.w : r.alphas.z) : (later.x ? r.alphas.y : r.alphas.x)).age;
}

bool light_changes(Around around) { return (around.own & KEY_LIGHT_CHANGES) != 0; }

/// By which a colour turns from the hue of sky towards that of sun and sky, with lightness between those of the two; both hues
/// are of the open. Not from a share of light: divisions cost, and in the light of a noon it differs from this by less than a
/// quarter of the way, which is 4% of a colour.
vec3 tint_of(float is, float was) {
  float between = clamp(is, frame.sky_lightness, frame.open_lightness) - clamp(was, frame.sky_lightness, frame.open_lightness);
  return 1 + frame.open_over_sky * between;
}

/// Where light may have changed, a history whose light was not between the pixel's and the mean of those around is lit anew,
/// as a matt surface would be.
void follow_light(inout Reprojected r, Around around) {
  if (!light_changes(around)) return;
  const float coarse = 0.9;  // beyond it a step is too much of the light to tell how it changed
  float now = lightness_of_key(around.own);
  if (max(now, r.lightness) > coarse) r.causes |= reject_visibility;
  float bounded = clamp(r.lightness, min(now, around.mean), max(now, around.mean));
  const float least_step = 0.5;  // below it lies what arithmetic leaves of even light
  if (abs(bounded - r.lightness) * KEY_LIGHT_STEPS < least_step) return;
  const float most_change = 16;
  vec2 is = light_fraction(bounded), was = light_fraction(r.lightness);
  float change = clamp(is.x * was.y / max(was.x * is.y, 1e-6), 1 / most_change, most_change);
  r.found *= change * tint_of(bounded, r.lightness);
  r.lightness = bounded;
  r.count *= change > 1 ? 1 / change : change;
  r.causes |= reject_visibility;
}

#endif
