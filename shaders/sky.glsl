// The sky of this frame.
#ifndef UNGHOST_SKY_GLSL
#define UNGHOST_SKY_GLSL

#include "frame.glsl"
#include "shared/sky.h"

vec3 sky_radiance(vec3 d, float roughness) {
  return radiance_of(Sky(frame.sky_zenith, frame.sky_horizon, frame.ground, frame.towards_sun), d, roughness);
}

float value_noise(vec2 p) {
  vec2 cell = floor(p), at = p - cell;
  at = at * at * (3 - 2 * at);
  uvec2 low = uvec2(ivec2(cell));
  // of whole numbers, so that a corner is the same from each of its cells
  uvec4 seed = (uvec4(low.x, low.x + 1, low.x, low.x + 1) * 1664525u) ^ (uvec4(low.y, low.y, low.y + 1, low.y + 1) * 22695477u);
  seed = (seed ^ (seed >> 15)) * 2246822519u;
  seed = (seed ^ (seed >> 13)) * 3266489917u;
  vec4 corners = vec4((seed ^ (seed >> 16)) >> 8) / 16777216.0;
  return mix(mix(corners.x, corners.y, at.x), mix(corners.z, corners.w, at.x), at.y);
}

/// What the camera sees where nothing stands: the sky, thin clouds, the sun's disc.
vec3 visible_sky(vec3 d) {
  vec3 sky = sky_radiance(d, 0);
  if (d.y > 0.02) {
    vec2 at = d.xz / (d.y + 0.12) * 1.3;
    float cloud = value_noise(at) * 0.55 + value_noise(at * 2.7 + 5.1) * 0.3 + value_noise(at * 6.3 + 1.7) * 0.15;
    cloud = smoothstep(0.48, 0.85, cloud) * smoothstep(0.02, 0.2, d.y) * 0.75;
    sky = mix(sky, frame.sky_horizon * 1.25, cloud);
  }
  const float cos_disc = 0.99994, disc_radiance = 60;
  return dot(d, frame.towards_sun) > cos_disc ? frame.sun_illuminance * disc_radiance : sky;
}

#endif
