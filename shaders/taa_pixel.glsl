// What one pixel becomes, once its neighbourhood is known. The naive and the fast resolve share this; they differ in how
// they come to the neighbourhood, to the pixel that speaks for it, and to the volume that bounds its history.
#ifndef UNGHOST_TAA_PIXEL_GLSL
#define UNGHOST_TAA_PIXEL_GLSL

#include "taa_colour.glsl"
#include "taa_rectify.glsl"
#include "taa_rejection.glsl"

/// Weights of three pixels in a row that interpolate where the middle one would be without jitter. Samples that are to be
/// averaged over many frames lie beside it in turns; where few are, that is noise.
vec3 centred_weights(float jitter_px) { return max(vec3(0), 1 - abs(vec3(-1, 0, 1) - jitter_px)); }

/// What a pixel becomes, and why.
struct Resolve {
  vec3 colour;
  float weight;  // of the current frame
  float count;   // frames that it holds
  float lightness;  // of what falls on it
  uint causes;   // of the history's rejection, in whole or in part: bits of `reject`
  float rectified;  // how far the history was moved: 1 by a tenth of itself or more
  vec3 history;     // as it was used
  vec3 found, bounded;  // for the probe: as it was read or lit anew, linear; rectified, in the working space
  vec3 mixed_in;     // of the frame
  bool has_history, bounds;  // for the probe: it was bounded by colours
};

Resolve without_history(vec3 centre, Speaker speaker) {
  float lightness = keyed() ? lightness_of_key(speaker.around.own) : 0;
  return Resolve(centre, 1, 1, lightness, 0, 0, centre, vec3(0), vec3(0), centre, false, false);
}

/// The weight of the current frame where nothing is rejected.
float speed_weight(Reprojected r, Speaker speaker) {
  float weight = mix(push.alpha, push.fast_alpha, fast_share(r)) + push.zoom_weight * zoom_of(speaker.key);
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
  if (writes_to(TAA_WRITES_PROBE))
    result.found = r.found, result.bounded = bounded, result.mixed_in = centre, result.has_history = true,
    result.bounds = needs_bounds(speaker, r);
  if (writes_to(TAA_WRITES_HISTORY)) result.history = from_working(bounded);
  if (j.whole) return result;
  float weight = mix(blend_weight(r, speaker, moved), 1, j.share);
  vec3 colour = needs_blurred() ? mix(centre, blurred, j.share) : centre;
  result.colour = weight >= 1 ? colour : average(r, bounded, colour, weight);
  if (rejects(reject_velocity)) result.colour = mix(result.colour, needs_blurred() ? blurred : centre, j.drawn);
  result.weight = mix(weight, 1, j.drawn);
  result.count = result.weight >= 1 ? 1 : min(r.count + 1, most_frames());
  if (keyed() && keeps != keeps_input) result.lightness = mix(r.lightness, result.lightness, result.weight);
  return result;
}

#endif
