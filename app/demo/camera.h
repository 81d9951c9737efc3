// A person's camera: where the rig has it, turned around the vehicle, moved, or flown away with.
#pragma once

#include <optional>

#include "renderer/frame_input.h"

namespace unghost {

constexpr double nearest_camera = 0.2, farthest_camera = 8; // times the rig's distance

/// What a person has done to the rig's camera.
struct CameraOffset {
  double yaw = 0, pitch = 0; // radians about the vehicle, to the camera's right and up
  double distance = 1;       // times the rig's
  glm::dvec3 pan{0};         // metres, in the camera's axes
  struct Flown {
    glm::dvec3 eye;
    glm::dquat camera;
    bool operator==(const Flown&) const = default;
  };
  std::optional<Flown> flown; // in the world; then the rest is not read

  bool operator==(const CameraOffset&) const = default;
};

/// What a person asks of the camera in one frame. All of it moves or turns the camera; what is dragged by
/// hand goes the other way.
struct CameraInput {
  glm::dvec2 orbit{0}; // radians about the vehicle, right and up
  glm::dvec2 pan{0};   // shares of the picture's height at the vehicle's distance, right and up
  double zoom = 0;     // in steps of a wheel; positive is nearer
  glm::dvec3 fly{0};   // -1 to 1 each: right, up, forward; any of it flies
  glm::dvec2 look{0};  // radians, while flying: right and up
  double fast = 1;     // times the usual speed
};

/// `rig`: the frame's instant as the rig has it; `seconds` of a person's time. What flies is neither turned
/// about the vehicle nor moved with it.
void steer(CameraOffset& offset, const CameraInput& input, const Instant& rig, double seconds);
/// The rig's instant with the person's camera; to the bit, where a person has done nothing.
Instant with_camera(const CameraOffset& offset, Instant rig);

} // namespace unghost
