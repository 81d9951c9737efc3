// The space in which colours are bounded and averaged: a weighting against bright pixels, then RGB or YCoCg.
#ifndef UNGHOST_TAA_COLOUR_GLSL
#define UNGHOST_TAA_COLOUR_GLSL

#include "taa_inputs.glsl"

const float log_offset = 4.54e-5;  // keeps 0 out of the logarithm, and comes off again: black stays black

vec3 ycocg_from_rgb(vec3 c) {
  return vec3(dot(c, vec3(0.25, 0.5, 0.25)), dot(c, vec3(0.5, 0, -0.5)), dot(c, vec3(-0.25, 0.5, -0.25)));
}
vec3 rgb_from_ycocg(vec3 c) { return vec3(c.x + c.y - c.z, c.x + c.z, c.x - c.y - c.z); }

/// An average of c / (1 + L) that is turned back is the average of c weighted with 1 / (1 + L) (Karis 2014).
vec3 weighted(vec3 colour) {
  switch (weighting) {
  case weighting_inverse_luminance: return colour / (1 + luminance(colour));
  case weighting_log: return log(max(colour, vec3(0)) + log_offset);
  default: return colour;
  }
}
vec3 unweighted(vec3 colour) {
  switch (weighting) {
  case weighting_inverse_luminance: {
    vec3 positive = max(colour, vec3(0));
    return positive / max(1 - luminance(positive), 1e-5);
  }
  case weighting_log: return max(exp(colour) - log_offset, vec3(0));
  default: return max(colour, vec3(0));
  }
}

vec3 to_working(vec3 colour) {
  vec3 c = weighted(colour);
  return space == space_ycocg ? ycocg_from_rgb(c) : c;
}
vec3 from_working(vec3 colour) { return unweighted(space == space_ycocg ? rgb_from_ycocg(colour) : colour); }

/// What the inverse weighting diverges in.
float weighted_luminance(vec3 working) { return luminance(space == space_ycocg ? rgb_from_ycocg(working) : working); }

#endif
