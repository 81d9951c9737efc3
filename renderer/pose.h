// Where every node is at one instant.
#pragma once

#include <vector>

#include "renderer/frame_input.h"

namespace unghost {

/// Node to world for each node: the scene's first animation at its clock, wheels rolled and steered, the
/// vehicle where the rig has it.
std::vector<glm::dmat4> pose(const Scene& scene, const Instant& instant);

} // namespace unghost
