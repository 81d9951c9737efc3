#include <algorithm>

#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {
namespace {

/// What is told of a pixel beside its motion.
struct Told {
  bool key = false;   // for known causes
  bool light = false; // in it
};

Told asked_of(FrameGraph& graph, const FrameContext& in, bool lit, ImageRef key) {
  const auto any = [&](auto asks) {
    return std::ranges::any_of(in.modes, [&](const ModeRun& run) { return asks(run.taa.policy); });
  };
  const bool keyed = any([](const TaaPolicy&policy) { return policy.needs_key(); }),
             relit = any([](const TaaPolicy&policy) { return policy.rejects(Reject::visibility); });
  if (!graph.needed(keyed, {"keys", "no mode asks for known causes"}, {key})) return {};
  return {.key = true, .light = lit && graph.needed(relit, {"light of keys", "no mode follows it"})};
}

std::vector<Binding> bindings_of(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer,
                                 ImageRef irradiance, const Motion& motion, Told told) {
  // Neutral images that are sampled have formats of their own: in one pass an image has one layout.
  const auto read_if = [&](bool is, uint32_t slot, ImageRef read, VkFormat format) {
    return storage_read(slot, is ? read : graph.neutral(format));
  };
  return {uniform(FRAME_BINDING, in.constants),
          sampled(MOTION_DEPTH, gbuffer.surfaces ? gbuffer.depth : graph.neutral(VK_FORMAT_R8_UNORM)),
          read_if(gbuffer.moves, MOTION_OF_OBJECTS, gbuffer.object_motion, VK_FORMAT_R32G32B32A32_SFLOAT),
          gbuffer.tagged ? sampled_stencil(MOTION_TAG, gbuffer.depth)
                         : sampled(MOTION_TAG, graph.neutral(VK_FORMAT_R16_UINT)),
          read_if(told.key && gbuffer.surfaces, MOTION_OBJECT, gbuffer.object, VK_FORMAT_R32_UINT),
          read_if(told.light, MOTION_IRRADIANCE, irradiance, VK_FORMAT_R8_UINT),
          storage_write(MOTION_KEY_OUT, motion.key),
          storage_write(MOTION_OUT, motion.motion_px),
          storage_write(MOTION_PREVIOUS_DEPTH_OUT, motion.previous_depth),
          storage_write(MOTION_DEPTH_OUT, motion.depth)};
}

} // namespace

Motion resolve_motion(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer, const Lit& lit) {
  const auto image = [&](const char* name, VkFormat format) {
    return graph.image({.name = name, .format = format, .extent = in.size});
  };
  Motion motion{.motion_px = image("motion", VK_FORMAT_R32G32_SFLOAT),
                .previous_depth = image("previous depth", VK_FORMAT_R32_SFLOAT),
                .key = image("keys", VK_FORMAT_R32_UINT),
                .depth = image("depth copy", VK_FORMAT_R32_SFLOAT)};
  motion.moves =
      graph.needed(in.camera_moved || in.in_view.anything_moved,
                   {"motion", "neither the camera nor anything in view moves"}, {motion.motion_px});
  const Told asked = asked_of(graph, in, gbuffer.lit, motion.key);
  graph.compute({.name = "motion",
                 .shader = "motion.comp",
                 .constants = {uint32_t(gbuffer.moves),
                               motion.previous_depth,
                               motion.depth,
                               uint32_t(gbuffer.surfaces),
                               uint32_t(gbuffer.tagged),
                               {0, {{motion.key, uint32_t(asked.key)}}},
                               uint32_t(asked.light)},
                 .bindings = bindings_of(graph, in, gbuffer, lit.irradiance, motion, asked),
                 .cover = in.size});
  return motion;
}

} // namespace unghost
