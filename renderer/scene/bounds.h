// How much room a scene takes in its default pose.
#pragma once

#include <array>

#include "renderer/scene/scene.h"

namespace unghost {

std::array<glm::dvec4, 8> corners_of(const Bounds& box);

/// The box around `box` after `matrix`.
Bounds transformed(const Bounds& box, const glm::dmat4& matrix);

/// Of all meshes that nodes draw, in world space. Turned meshes take the box of their turned box: never too
/// small.
Bounds scene_bounds(const Scene& scene);

/// Of the meshes of `node` and of all nodes below it, in world space.
Bounds node_bounds(const Scene& scene, int node);

/// Of the vehicle in the frame of its own node, wherever the file has parked it. Empty where there is none.
Bounds vehicle_bounds(const Scene& scene);

/// For each node whether it is `node` or below it.
std::vector<bool> subtree_of(const Scene& scene, int node);

} // namespace unghost
