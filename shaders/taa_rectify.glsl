// Bounding the history by the volume of its neighbourhood. A clip goes along the segment from the current colour, which
// lies in the volume, to the history; what is inside comes out unchanged to the bit.
#ifndef UNGHOST_TAA_RECTIFY_GLSL
#define UNGHOST_TAA_RECTIFY_GLSL

/// Mean and sum of squares about it of a row of three; and mean, and gamma standard deviations, of three such rows. Exact
/// where sums of squares about another place would cancel (Chan, Golub and LeVeque 1979). Both resolves take them this
/// way: on grey asphalt the chroma of a neighbourhood hardly differs, and what a clip leaves depends on every bit of it.
#define ROW_MOMENTS(a, b, c, mean, squares)                                                                  \
  mean = (a + b + c) * (1.0 / 3);                                                                            \
  squares = (a - mean) * (a - mean) + (b - mean) * (b - mean) + (c - mean) * (c - mean)
#define NINE_MOMENTS(T, i, means, squares_of, mean, reach)                                                   \
  T mean = (means[i] + means[i + 1] + means[i + 2]) * (1.0 / 3);                                             \
  T above = means[i] - mean, middle = means[i + 1] - mean, below = means[i + 2] - mean;                      \
  T reach = push.gamma * sqrt((squares_of[i] + squares_of[i + 1] + squares_of[i + 2] +                       \
                               3 * (above * above + middle * middle + below * below)) * (1.0 / 9))

/// How far along `from` to `to` the slab `low` to `high` reaches; `from` lies in it. Infinite where they are one.
float slab_share(float low, float high, float from, float to) {
  float d = to - from;
  return ((d > 0 ? high - from : from - low) + 1e-30) / abs(d);
}

vec3 on_segment(vec3 centre, vec3 history, float share) {
  return share >= 1 ? history : centre + (history - centre) * max(share, 0);
}

/// A clamp takes each channel by itself, and may join the bright ones of several colours: weighted by luminance that
/// would be a colour brighter than any. Not brighter than the brightest of what it was made from.
bool may_brighten() {
  bool clamps = rectify == rectify_box_clamp || rectify == rectify_variance_clamp;
  return clamps && weighting == weighting_inverse_luminance;
}
vec3 not_brighter(vec3 bounded, vec3 found, float brightest) {
  return bounded * min(1, max(brightest, weighted_luminance(found)) / max(weighted_luminance(bounded), 1e-6));
}

/// How far a history was moved: 1 by a tenth of itself or more.
float moved_by(vec3 found, vec3 bounded) {
  return clamp(length(bounded - found) / (0.1 * length(found) + 0.01), 0, 1);
}

vec3 clip_to_box(vec3 history, vec3 centre, vec3 low, vec3 high) {
  float x = slab_share(low.x, high.x, centre.x, history.x), y = slab_share(low.y, high.y, centre.y, history.y),
        z = slab_share(low.z, high.z, centre.z, history.z);
  return on_segment(centre, history, min(x, min(y, z)));
}

#endif
