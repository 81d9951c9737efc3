#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

Resolved resolve_taa(FrameGraph& graph, const FrameContext& in, const TaaInputs& inputs, size_t place) {
  const TaaSettings& taa = in.modes[place].taa;
  const TaaPolicy& policy = taa.policy;
  if (!policy.needs_history()) return {.colour = inputs.colour, .why = {}};

  const std::string key = "history " + std::to_string(place);
  const bool reset = in.cut || in.policy_changed[place];
  const History colour =
      graph.history(key, {.format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = in.size}, reset);
  const bool keeps_tags = policy.needs_previous_tags() && in.scene.traits.tagged;
  const ImageRef no_tag = graph.neutral(VK_FORMAT_R8_UINT);
  History tags{.previous = no_tag, .next = graph.image({.name = "no tags", .format = VK_FORMAT_R8_UINT})};
  if (keeps_tags)
    tags = graph.history("tags of " + key, {.format = VK_FORMAT_R8_UINT, .extent = in.size}, reset);
  const ImageRef why = graph.image({.name = "why", .format = VK_FORMAT_R8G8B8A8_UNORM, .extent = in.size});
  const TaaPush push{.alpha = taa.alpha,
                     .motion_threshold_px = taa.motion_threshold_px,
                     .near_m = taa.near_m,
                     .far_m = taa.far_m,
                     .frame = uint32_t(in.index)};
  const auto bytes = std::as_bytes(std::span(&push, 1));
  // Without a history the frame is taken as it is: nothing is made for questions that nobody asks.
  const bool has_history = colour.valid && (!keeps_tags || tags.valid);
  const bool reads_tags = in.scene.traits.tagged && (keeps_tags || (has_history && policy.needs_tags()));
  const ImageRef motion = has_history ? inputs.motion.motion_px : graph.neutral(VK_FORMAT_R32G32_SFLOAT);
  const ImageRef depth =
      has_history || keeps_tags ? inputs.gbuffer.depth : graph.neutral(VK_FORMAT_R32_SFLOAT);
  graph.compute(
      {.name = "taa " + in.modes[place].name,
       .shader = "taa.comp",
       .constants = {uint32_t(policy.dilation), uint32_t(policy.history), uint32_t(policy.rectify),
                     uint32_t(policy.reject), uint32_t(reads_tags), uint32_t(keeps_tags), why,
                     uint32_t(has_history)},
       .bindings = {uniform(FRAME_BINDING, in.constants), sampled(TAA_COLOUR, inputs.colour),
                    sampled(TAA_PREVIOUS, colour.previous), sampled(TAA_DEPTH, depth),
                    sampled(TAA_MOTION, motion),
                    reads_tags ? sampled_stencil(TAA_TAG, inputs.gbuffer.depth) : sampled(TAA_TAG, no_tag),
                    sampled(TAA_PREVIOUS_TAG, tags.previous), storage_write(TAA_OUT, colour.next),
                    storage_write(TAA_TAG_OUT, tags.next), storage_write(TAA_WHY_OUT, why)},
       .push = {bytes.begin(), bytes.end()},
       .cover = in.size});
  return {.colour = colour.next, .why = why};
}

} // namespace unghost
