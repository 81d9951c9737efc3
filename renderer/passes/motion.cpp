#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

Motion resolve_motion(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer) {
  const Motion motion{
      .motion_px = graph.image({.name = "motion", .format = VK_FORMAT_R32G32_SFLOAT, .extent = in.size}),
      .previous_depth =
          graph.image({.name = "previous depth", .format = VK_FORMAT_R32_SFLOAT, .extent = in.size})};
  graph.compute({.name = "motion",
                 .shader = "motion.comp",
                 .constants = {uint32_t(in.anything_moved), motion.previous_depth},
                 .bindings = {uniform(FRAME_BINDING, in.constants), sampled(MOTION_DEPTH, gbuffer.depth),
                              sampled(MOTION_OF_OBJECTS, gbuffer.object_motion),
                              storage_write(MOTION_OUT, motion.motion_px),
                              storage_write(MOTION_PREVIOUS_DEPTH_OUT, motion.previous_depth)},
                 .cover = in.size});
  return motion;
}

}  // namespace unghost
