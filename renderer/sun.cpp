#include "renderer/sun.h"

#include <cmath>

#include "shaders/shared/sky.h"
#include "shaders/shared/taa_key.h"

namespace unghost {
namespace {

constexpr double covered_m = 72; // side of the square that the map covers
constexpr double step_m = 9;     // it moves in steps of this, so that it is seldom drawn anew: 256 texels
constexpr double ahead_m = 22;   // its middle lies this far before the camera
constexpr double depth_m = 240;  // along the sun's rays, where the steps are larger: nobody sees them
constexpr double depth_step_m = 60;
constexpr float pi = 3.14159f;

struct SunFrame {
  glm::dvec3 right, up, towards;
};

SunFrame frame_of(glm::dvec3 towards) {
  const glm::dvec3 helper = std::abs(towards.y) > 0.99 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(helper, towards));
  return {right, glm::cross(towards, right), towards};
}

/// Middle of the map's square, along the sun's axes.
glm::dvec3 place_of_map(const FrameInput& input, const SunFrame& sun) {
  glm::dvec3 ahead = input.now.camera * glm::dvec3(0, 0, -1);
  ahead.y = 0;
  const double length = glm::length(ahead);
  const glm::dvec3 middle =
      glm::dvec3(input.now.eye.x, 0, input.now.eye.z) + (length > 0.2 ? ahead / length : ahead) * ahead_m;
  const auto snapped = [&](glm::dvec3 axis, double step) {
    return std::round(glm::dot(middle, axis) / step) * step;
  };
  return {snapped(sun.right, step_m), snapped(sun.up, step_m), snapped(sun.towards, depth_step_m)};
}

/// The unit steps with the exposure, by its doubles: histories hold light in it (LastFrame::light_unit).
void describe_light_of_keys(FrameConstants& constants, const LightSettings& light) {
  constexpr float brighter = 1.6f; // a clear noon, than what a white surface shows as 1
  constants.light_unit = brighter * pi / std::exp2(std::round(light.exposure_ev));
  const Sky sky{constants.sky_zenith, constants.sky_horizon, constants.ground, constants.towards_sun};
  const glm::vec3 of_sky = pi * radiance_of(sky, {0, 1, 0}, 1),
                  of_sun = constants.sun_illuminance * std::max(constants.towards_sun.y, 0.0f),
                  open = of_sky + of_sun;
  constants.open_sky_light = luminance(of_sky) / constants.light_unit;
  constants.open_sun_light = luminance(of_sun) / constants.light_unit;
  constants.sky_lightness = lightness_of(constants.open_sky_light);
  constants.open_lightness = lightness_of(constants.open_sky_light + constants.open_sun_light);
  constants.open_over_sky = glm::vec3(0);
  if (constants.sky_lightness <= 0 || constants.open_lightness <= constants.sky_lightness) return; // one hue
  const glm::vec3 sky_hue = of_sky / luminance(of_sky), open_hue = open / luminance(open);
  constants.open_over_sky = (open_hue - sky_hue) / (0.5f * (open_hue + sky_hue)) /
                            (constants.open_lightness - constants.sky_lightness);
}

} // namespace

void describe_light(FrameConstants& constants, const FrameInput& input) {
  const LightSettings& light = input.settings.light;
  constants.towards_sun = glm::normalize(input.now.towards_sun);
  constants.sun_illuminance = glm::vec3(1.0f, 0.93f, 0.82f) * (5.2f * light.sun_illuminance);
  constants.sky_zenith = glm::vec3(0.17f, 0.32f, 0.62f) * light.sky_luminance;
  constants.sky_horizon = glm::vec3(0.62f, 0.72f, 0.84f) * light.sky_luminance;
  const float share = 0.14f * (std::max(constants.towards_sun.y, 0.0f) / pi);
  constants.ground = constants.sun_illuminance * share + constants.sky_horizon * 0.1f;
  constants.exposure = std::exp2(light.exposure_ev);
  describe_light_of_keys(constants, light);
}

std::vector<double> describe_shadow_map(FrameConstants& constants, const FrameInput& input) {
  const SunFrame sun = frame_of(glm::normalize(input.now.towards_sun));
  const glm::dvec3 at = place_of_map(input, sun);
  const glm::dvec3 axes[] = {sun.right, sun.up, sun.towards};
  const glm::dvec3 scale(1 / covered_m, 1 / covered_m, -1 / depth_m);
  glm::dmat4 shadow_from_eye(1.0);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) shadow_from_eye[column][row] = axes[row][column] * scale[row];
    shadow_from_eye[3][row] = (glm::dot(input.now.eye, axes[row]) - at[row]) * scale[row] + 0.5;
  }
  constants.shadow_from_eye = shadow_from_eye;
  constants.shadow_texels = float(shadow_texels);
  constants.shadow_texel_m = float(covered_m / shadow_texels);
  return {at.x, at.y, at.z, sun.towards.x, sun.towards.y, sun.towards.z};
}

} // namespace unghost
