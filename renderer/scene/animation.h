// Poses: key frames at a time, and where that puts every node.
#pragma once

#include <span>
#include <vector>

#include "renderer/scene/scene.h"

namespace unghost {

/// Each node's Trs as the scene has it; a node with a matrix keeps that whatever its Trs says.
std::vector<Trs> default_pose(const Scene& scene);

/// Writes what `animation` moves at `seconds` into `local`, one for each node, and leaves the rest. Before
/// the first and after the last key of a track its end value holds; looping is the caller's.
void sample(const Animation& animation, double seconds, std::span<Trs> local);

glm::dmat4 matrix_of(const Trs& local);

/// Local to world for each node of the scene, in double precision so that a car far from the origin moves
/// evenly.
std::vector<glm::dmat4> world_matrices(const Scene& scene, std::span<const Trs> local);

} // namespace unghost
