// Rigs: where the camera, the vehicle and the sun are at one moment, as pure functions of time.
#pragma once

#include <span>
#include <string_view>

#include "renderer/frame_input.h"

namespace unghost {

/// Width, height and length of the car that the rigs are laid out for, in metres; what is larger or smaller
/// moves the camera with it.
constexpr glm::dvec3 usual_car_m{1.85, 1.4, 4.4};

/// What a rig is fitted to. Lengths in metres.
struct RigContext {
  uint64_t seed = 1;         // 1: as designed; others move start, side, sun and speed a little
  double track_radius = 150; // of the circle that the vehicle follows
  Bounds vehicle;            // in its own frame: +z forward, +y up, +x left, origin on the ground
  StageSettings stage;       // speed
  LightSettings light;       // the sun's place
};

/// One row of the table of rigs.
struct Rig {
  std::string_view name, summary;
  Instant (*at)(const RigContext& context, double time_s);
};

constexpr double seconds_per_frame = 1.0 / 60.0;

std::span<const Rig> rigs();
/// The rig of that name, or nothing.
const Rig* find_rig(std::string_view name);

} // namespace unghost
