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

glm::dvec2 jitter_offset(Jitter sequence, uint64_t index) {
  switch (sequence) {
  case Jitter::none:
    return {0, 0};
  case Jitter::halton_8: {
    const uint64_t n = index % 8 + 1; // from 1: the sequence's first point is its corner
    return {radical_inverse(n, 2) - 0.5, radical_inverse(n, 3) - 0.5};
  }
  }
  return {0, 0};
}

Projected project(const Instant& instant, glm::dvec3 position_world, uint32_t width, uint32_t height) {
  const glm::dvec3 view = glm::inverse(instant.camera) * (position_world - instant.eye);
  const glm::dvec2 tangent = tangent_of(instant, width, height);
  const glm::dvec2 ndc = glm::dvec2(view.x, -view.y) / (-view.z * tangent);
  return {(ndc + 1.0) * 0.5 * glm::dvec2(width, height), -view.z};
}

} // namespace unghost
