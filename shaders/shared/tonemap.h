// From linear light to what the screen shows; the same curve for the frame and for what is measured of it.
#ifndef UNGHOST_SHARED_TONEMAP_H
#define UNGHOST_SHARED_TONEMAP_H

#include "language.h"

SHARED_BEGIN
#ifdef __cplusplus
using glm::clamp, glm::mix, glm::pow, glm::max, glm::lessThan;
#endif
/// sRGB in [0, 1] from linear light already multiplied by the exposure. The curve is Narkowicz's fit of the
/// ACES filmic tone mapping (2015).
SHARED_FUNCTION vec3 display_from_linear(vec3 colour) {
  vec3 x = max(colour, vec3(0.0f));
  vec3 mapped = clamp((x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f), vec3(0.0f), vec3(1.0f));
  vec3 curved = 1.055f * pow(mapped, vec3(1.0f / 2.4f)) - 0.055f;
  return mix(curved, mapped * 12.92f, vec3(lessThan(mapped, vec3(0.0031308f))));
}
SHARED_END

#endif
