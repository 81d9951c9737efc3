#include "renderer/view.h"

#include <cmath>

namespace unghost {
namespace {

glm::dvec2 tangent_of(const Instant& instant, uint32_t width, uint32_t height) {
  const double down = std::tan(instant.vertical_fov * 0.5);
  return {down * width / height, down};
}

/// Reversed depth, infinite far plane, y down on the picture.
glm::dmat4 projection(glm::dvec2 tangent, double near_plane, glm::dvec2 shift_ndc) {
  glm::dmat4 clip_from_view(0.0);
  clip_from_view[0][0] = 1 / tangent.x;
  clip_from_view[1][1] = -1 / tangent.y;
  clip_from_view[2] = {-shift_ndc.x, -shift_ndc.y, 0, -1};
  clip_from_view[3][2] = near_plane;
  return clip_from_view;
}

double radical_inverse(uint64_t index, uint64_t base) {
  double digit = 1, value = 0;
  for (; index > 0; index /= base) value += double(index % base) * (digit /= double(base));
  return value;
}

} // namespace

void describe_camera(FrameConstants& constants, const FrameInput& input, glm::dvec2 jitter_px) {
  const glm::dvec2 size(input.width, input.height);
  const glm::dvec2 tangent = tangent_of(input.now, input.width, input.height);
  const glm::dvec2 tangent_before = tangent_of(input.before, input.width, input.height);
  const glm::dmat3 eye_from_view = glm::mat3_cast(input.now.camera);
  const glm::dmat3 view_from_eye_before = glm::transpose(glm::mat3_cast(input.before.camera));

  constants.clip_from_eye = projection(tangent, input.now.near_plane, 2.0 * jitter_px / size) *
                            glm::dmat4(glm::transpose(eye_from_view));
  constants.previous_clip_from_eye =
      projection(tangent_before, input.before.near_plane, {0, 0}) * glm::dmat4(view_from_eye_before);
  constants.eye_from_view = eye_from_view;
  // A product with its own inverse is not the identity to the last bit; a camera that rests must not move at
  // all.
  const bool rests = input.now.camera == input.before.camera;
  constants.reprojection_turn =
      rests ? glm::dmat3(0.0) : view_from_eye_before * eye_from_view - glm::dmat3(1.0);
  constants.reprojection_shift = view_from_eye_before * (input.now.eye - input.before.eye);
  constants.size_px = size;
  constants.inverse_size_px = 1.0 / size;
  constants.jitter_px = jitter_px;
  constants.tangent = tangent;
  constants.previous_over_tangent = 1.0 / tangent_before - 1.0 / tangent;
  constants.near_plane = float(input.now.near_plane);
}

namespace {

/// Halton 1960, from its second point on: the first is the corner.
glm::dvec2 halton(uint64_t n) { return {radical_inverse(n + 1, 2) - 0.5, radical_inverse(n + 1, 3) - 0.5}; }

/// The GDK sample's.
glm::dvec2 blue_noise(uint64_t n) {
  static constexpr double points[16][2] = {
      {1.5, .59375},    {1.21875, 1.375},  {1.6875, 1.90625}, {.375, .84375},
      {1.125, 1.875},   {.71875, 1.65625}, {1.9375, .71875},  {.65625, .125},
      {.90625, .9375},  {1.65625, 1.4375}, {.5, 1.28125},     {.21875, .0625},
      {1.84375, .3125}, {1.09375, .5625},  {.0625, 1.21875},  {.28125, 1.65625}};
  return glm::dvec2(points[n][0], points[n][1]) / 2.0 - 0.5;
}

} // namespace

// Multiples of the plastic number's inverse powers.
glm::dvec2 r2_sequence(uint64_t n) {
  constexpr double plastic = 1.32471795724475;
  const glm::dvec2 at = 0.5 + double(n) * glm::dvec2(1 / plastic, 1 / (plastic * plastic));
  return glm::fract(at) - 0.5;
}

namespace {

// Ten points of R2 lie a tenth of a pixel beside the middle in the mean, and so would all that is made of
// them.
glm::dvec2 r2_10(uint64_t n) {
  static const glm::dvec2 mean = [] {
    glm::dvec2 sum(0);
    for (uint64_t i = 0; i < 10; ++i) sum += r2_sequence(i);
    return sum / 10.0;
  }();
  return r2_sequence(n) - mean;
}

} // namespace

uint32_t jitter_cycle(Jitter sequence) {
  switch (sequence) {
  case Jitter::none:
    return 1;
  case Jitter::two_samples:
    return 2;
  case Jitter::rotated_grid:
    return 4;
  case Jitter::halton_8:
    return 8;
  case Jitter::r2_10:
    return 10;
  case Jitter::halton_16:
  case Jitter::blue_noise_16:
    return 16;
  }
  return 1;
}

glm::dvec2 jitter_offset(Jitter sequence, uint64_t index) {
  const uint64_t n = index % jitter_cycle(sequence);
  static constexpr double grid[4][2] = {{-.125, -.375}, {.375, -.125}, {-.375, .125}, {.125, .375}};
  switch (sequence) {
  case Jitter::none:
    return {0, 0};
  case Jitter::halton_8:
  case Jitter::halton_16:
    return halton(n);
  case Jitter::blue_noise_16:
    return blue_noise(n);
  case Jitter::r2_10:
    return r2_10(n);
  case Jitter::two_samples:
    return glm::dvec2(n == 0 ? -0.25 : 0.25);
  case Jitter::rotated_grid:
    return {grid[n][0], grid[n][1]};
  }
  return {0, 0};
}

bool camera_moves(const FrameInput& input) {
  const Instant &now = input.now, &before = input.before;
  return now.eye != before.eye || now.camera != before.camera || now.vertical_fov != before.vertical_fov;
}

double jitter_side(const TaaSettings& taa, const FrameInput& input) {
  if (taa.policy.jitter == Jitter::none) return 0;
  return double(taa.jitter_scale) * (camera_moves(input) ? double(taa.jitter_moving) : 1);
}

glm::dvec2 jitter_of(const TaaSettings& taa, const FrameInput& input) {
  if (input.jitter_px) return *input.jitter_px;
  return jitter_offset(taa.policy.jitter, input.index) * jitter_side(taa, input);
}

Projected project(const Instant& instant, glm::dvec3 position_world, uint32_t width, uint32_t height) {
  const glm::dvec3 view = glm::inverse(instant.camera) * (position_world - instant.eye);
  const glm::dvec2 tangent = tangent_of(instant, width, height);
  const glm::dvec2 ndc = glm::dvec2(view.x, -view.y) / (-view.z * tangent);
  return {(ndc + 1.0) * 0.5 * glm::dvec2(width, height), -view.z};
}

} // namespace unghost
