#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

Motion resolve_motion(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer) {
  const Motion motion{
      .motion_px = graph.image({.name = "motion", .format = VK_FORMAT_R32G32_SFLOAT, .extent = in.size}),
      .previous_depth =
          graph.image({.name = "previous depth", .format = VK_FORMAT_R32_SFLOAT, .extent = in.size}),
      .depth = graph.image({.name = "depth to load", .format = VK_FORMAT_R32_SFLOAT, .extent = in.size}),
      .tagged_depth =
          graph.image({.name = "tagged depth", .format = VK_FORMAT_R32_SFLOAT, .extent = in.size})};
  const ImageRef of_objects =
      in.anything_moved ? gbuffer.object_motion : graph.neutral(VK_FORMAT_R32G32B32A32_SFLOAT);
  graph.compute(
      {.name = "motion",
       .shader = "motion.comp",
       .constants = {uint32_t(in.anything_moved), motion.previous_depth, motion.depth, motion.tagged_depth},
       .bindings = {uniform(FRAME_BINDING, in.constants), sampled(MOTION_DEPTH, gbuffer.depth),
                    sampled(MOTION_OF_OBJECTS, of_objects), storage_write(MOTION_OUT, motion.motion_px),
                    storage_write(MOTION_PREVIOUS_DEPTH_OUT, motion.previous_depth),
                    storage_write(MOTION_DEPTH_OUT, motion.depth), sampled_stencil(MOTION_TAG, gbuffer.depth),
                    storage_write(MOTION_TAGGED_DEPTH_OUT, motion.tagged_depth)},
       .cover = in.size});
  return motion;
}

} // namespace unghost
