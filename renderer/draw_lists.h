// What of a scene is drawn in a frame, and in which order.
#pragma once

#include "renderer/passes/passes.h"

namespace unghost {

/// The scene's objects, one after the other, from this frame's eye and from the last one's.
struct PlacedObjects {
  std::vector<glm::dmat4> eye_from_object;
  std::vector<glm::mat4x3> previous_eye_from_object;
  std::vector<uint8_t> moved, mirrored;
  bool lamps_moved = false;
};

/// Fills `visible`, `plain`, `casters` and `in_view`. Returns the texels of the shadow map that moving
/// casters lie in.
VkRect2D list_draws(FrameGraph& graph, FrameContext& in, const FrameConstants& constants, const GpuScene& gpu,
                    const PlacedObjects& objects);

} // namespace unghost
