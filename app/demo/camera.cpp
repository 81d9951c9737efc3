#include "app/demo/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unghost {
namespace {

using glm::dquat, glm::dvec3;

constexpr dvec3 up{0, 1, 0};
constexpr double pivot_height_m = 1; // of what the camera turns about, over the ground below the vehicle
constexpr double zoom_of_a_step = 0.9;
constexpr double flying_m_per_s = 4;
constexpr double steepest = 89 * std::numbers::pi / 180; // up or down; at 90 degrees it would turn over

dvec3 pivot_of(const Instant& rig) { return dvec3(rig.vehicle[3]) + pivot_height_m * up; }

dvec3 forward_of(const dquat& camera) { return camera * dvec3(0, 0, -1); }

/// To the right, and level, whatever the camera's roll.
dvec3 level_right(const dquat& camera) {
  const dvec3 right = glm::cross(forward_of(camera), up);
  const double length = glm::length(right);
  return length > 1e-9 ? right / length : camera * dvec3(1, 0, 0); // looks straight up or down
}

/// How much of `pitch` a camera can look further up without turning over.
double allowed_pitch(const dquat& camera, double pitch) {
  const double now = std::asin(std::clamp(forward_of(camera).y, -1.0, 1.0));
  const double down = std::min(0.0, -steepest - now), more = std::max(0.0, steepest - now);
  return std::clamp(pitch, down, more);
}

/// What turns the rig's camera, and its place about the vehicle. The axis of the pitch is the camera's own
/// and level, so that neither the horizon tilts nor the vehicle moves in the picture.
dquat orbit_of(const CameraOffset& offset, const dquat& camera) {
  const double down = allowed_pitch(camera, -offset.pitch); // who climbs looks down
  return glm::angleAxis(offset.yaw, up) * glm::angleAxis(down, level_right(camera));
}

double distance_m(const CameraOffset& offset, const Instant& rig) {
  return offset.distance * glm::length(rig.eye - pivot_of(rig));
}

void orbit(CameraOffset& offset, const CameraInput& input, const Instant& rig) {
  offset.yaw += input.orbit.x;
  offset.pitch = -allowed_pitch(rig.camera, -(offset.pitch + input.orbit.y));
  offset.distance =
      std::clamp(offset.distance * std::pow(zoom_of_a_step, input.zoom), nearest_camera, farthest_camera);
  const double height_m = 2 * std::tan(rig.vertical_fov / 2) * distance_m(offset, rig);
  offset.pan += dvec3(height_m * input.pan, 0);
}

void fly(CameraOffset::Flown& flown, const CameraInput& input, double seconds) {
  const double up_more = allowed_pitch(flown.camera, input.look.y);
  flown.camera = glm::normalize(glm::angleAxis(-input.look.x, up) *
                                glm::angleAxis(up_more, level_right(flown.camera)) * flown.camera);
  const dvec3 share = input.fly / std::max(1.0, glm::length(input.fly)); // askew is no faster
  flown.eye += flown.camera * dvec3(share.x, share.y, -share.z) * (flying_m_per_s * input.fast * seconds);
}

} // namespace

void steer(CameraOffset& offset, const CameraInput& input, const Instant& rig, double seconds) {
  if (!offset.flown && input.fly != dvec3(0)) {
    const Instant here = with_camera(offset, rig);
    offset.flown = {.eye = here.eye, .camera = here.camera};
  }
  if (offset.flown)
    fly(*offset.flown, input, seconds);
  else
    orbit(offset, input, rig);
}

Instant with_camera(const CameraOffset& offset, Instant rig) {
  if (offset == CameraOffset{}) return rig;
  if (offset.flown) {
    rig.eye = offset.flown->eye;
    rig.camera = offset.flown->camera;
    return rig;
  }
  const dvec3 pivot = pivot_of(rig), arm = rig.eye - pivot;
  const dquat turn = orbit_of(offset, rig.camera);
  rig.camera = glm::normalize(turn * rig.camera);
  rig.eye = pivot + turn * (offset.distance * arm) + rig.camera * offset.pan;
  return rig;
}

} // namespace unghost
