// What of a scene is drawn in a frame, and in which order.
#pragma once

#include "renderer/passes/passes.h"

namespace unghost {

/// The scene's objects, one after the other, from this frame's eye and from the last one's.
struct PlacedObjects {
  std::vector<glm::dmat4> eye_from_object;
  std::vector<glm::mat4x3> previous_eye_from_object;
  std::vector<uint8_t> moved, mirrored;
  glm::dvec3 eye_moved{0}; // since the last frame, in the world
  bool lamps_moved = false;

  /// Where an object was, from this frame's eye.
  glm::dmat4 eye_from_object_before(size_t object) const {
    glm::dmat4 before(glm::dmat4x3(previous_eye_from_object[object]));
    before[3] -= glm::dvec4(eye_moved, 0);
    return before;
  }
};

/// Texels of the shadow map that casters lie in which move: in this frame, and in this frame or the last.
struct MovingShadows {
  VkRect2D now, swept;
};

/// Fills `visible`, `plain`, `casters` and `in_view`.
MovingShadows list_draws(FrameGraph& graph, FrameContext& in, const FrameConstants& constants,
                         const GpuScene& gpu, const PlacedObjects& objects);

} // namespace unghost
