#include "app/measure/stability/motion_oracle.h"

#include <algorithm>
#include <cmath>

#include "renderer/pose.h"
#include "renderer/view.h"

namespace unghost {
namespace {

/// Of the surface that pixel (x, y) shows, `depth` metres along the view axis.
glm::dvec3 position_world(const FrameInput& input, glm::dvec2 pixel, double depth) {
  const double down = std::tan(input.now.vertical_fov / 2);
  const glm::dvec2 size(input.width, input.height);
  const glm::dvec2 ndc = pixel / size * 2.0 - 1.0;
  const glm::dvec3 view(ndc.x * down * size.x / size.y * depth, -ndc.y * down * depth, -depth);
  return input.now.eye + input.now.camera * view;
}

/// What is no number is as wrong as can be.
void worsen(double& worst, double figure) { worst = std::isnan(figure) ? INFINITY : std::max(worst, figure); }

} // namespace

MotionDeviation motion_deviation(const Scene& scene, const FrameInput& input, glm::dvec2 jitter_px,
                                 const MotionImages& images) {
  constexpr double too_far_px = 10'000;
  const std::vector<glm::dmat4> now = pose(scene, input.now), before = pose(scene, input.before);
  MotionDeviation worst;
  for (uint32_t y = 0; y < input.height; ++y)
    for (uint32_t x = 0; x < input.width; ++x) {
      const size_t i = size_t(y) * input.width + x;
      if (images.object.values[i] == 0) continue;
      const size_t node = size_t(images.object.values[i]) - 1;
      const glm::dvec2 pixel = glm::dvec2(x, y) + 0.5 - jitter_px;
      const glm::dvec3 world = position_world(input, pixel, double(images.depth.values[i]));
      const glm::dvec3 was(before[node] * glm::inverse(now[node]) * glm::dvec4(world, 1));
      const Projected expected = project(input.before, was, input.width, input.height);
      const glm::dvec2 expected_px = expected.pixel - pixel;
      const glm::dvec2 found(images.motion.values[2 * i], images.motion.values[2 * i + 1]);
      if (expected.depth < 0 && !(glm::length(found) >= too_far_px)) worst.motion_px = INFINITY;
      if (expected.depth <= input.before.near_plane / 2 || glm::length(expected_px) > too_far_px) continue;
      worsen(worst.motion_px, glm::length(found - expected_px));
      worsen(worst.depth, std::abs(double(images.previous_depth.values[i]) / expected.depth - 1));
      worst.moving += now[node] != before[node];
      ++worst.surfaces;
    }
  return worst;
}

} // namespace unghost
