// Wheels of cars that say nothing about theirs.
#pragma once

#include <string_view>

#include "renderer/scene/scene.h"

namespace unghost {

/// Whether a node of this name is a wheel of a car: "wheel-front-left", not "steering wheel" or "wheel arch".
bool is_wheel_name(std::string_view name);

/// Where no node of the scene has a wheel, gives one to each node with a wheel's name (its mesh's, where it
/// has none) that draws something round about its x axis. Those with "front" in their name steer; without any
/// such name, those in the half with the greater z. What has the name and not the shape is said in the
/// scene's warnings.
void find_wheels_by_name(Scene& scene);

} // namespace unghost
