// An analytic sky that a surface of any roughness can ask: the rougher, the wider its gradients.
#ifndef UNGHOST_SHARED_SKY_H
#define UNGHOST_SHARED_SKY_H

#include "language.h"

SHARED_BEGIN
#ifdef __cplusplus
using glm::clamp, glm::dot, glm::max, glm::mix, glm::pow, glm::smoothstep, glm::sqrt;
#endif

struct Sky {
  vec3 zenith, horizon, ground;  // radiance
  vec3 towards_sun;
};

/// From direction d (world axes, length 1), averaged over a lobe of that roughness. No sun disc.
SHARED_FUNCTION vec3 radiance_of(Sky sky, vec3 d, float roughness) {
  float blur = 0.015f + roughness * 0.9f;
  float up = clamp(d.y, 0.0f, 1.0f);
  float to_zenith = pow(mix(up, 0.5f + 0.5f * d.y, roughness * 0.6f), 0.55f);
  // a wide lobe never sees the zenith alone
  vec3 above = mix(sky.horizon, sky.zenith, to_zenith * mix(1.0f, 0.3f, roughness));
  float towards = max(dot(d, sky.towards_sun), 0.0f);
  float width = mix(24.0f, 2.0f, sqrt(roughness));
  above += sky.horizon * vec3(1.0f, 0.85f, 0.6f) * (0.55f * pow(towards, width) * mix(1.0f, 0.35f, roughness));
  return mix(sky.ground, above, smoothstep(-blur, blur, d.y));
}

SHARED_END

#endif
