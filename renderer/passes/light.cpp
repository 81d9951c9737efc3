#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

Lit light(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer, ImageRef shadow_map) {
  const Lit lit{
      .colour = graph.image({.name = "lit", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = in.size}),
      .visibility = graph.image({.name = "sun visibility", .format = VK_FORMAT_R8_UNORM, .extent = in.size})};
  const ImageRef emissive =
      in.scene.traits.emissive ? gbuffer.emissive : graph.neutral(VK_FORMAT_R16G16B16A16_SFLOAT);
  graph.compute({.name = "light",
                 .shader = "light.comp",
                 .constants = {uint32_t(in.scene.traits.emissive), in.light_count, lit.visibility},
                 .bindings = {uniform(FRAME_BINDING, in.constants), sampled(LIGHT_ALBEDO, gbuffer.albedo),
                              sampled(LIGHT_NORMAL, gbuffer.normal),
                              sampled(LIGHT_MATERIAL, gbuffer.material), sampled(LIGHT_EMISSIVE, emissive),
                              sampled(LIGHT_DEPTH, gbuffer.depth), sampled(LIGHT_SHADOW_MAP, shadow_map),
                              buffer(LIGHT_LIGHTS, in.lights), storage_write(LIGHT_OUT, lit.colour),
                              storage_write(LIGHT_VISIBILITY_OUT, lit.visibility)},
                 .cover = in.size});
  return lit;
}

} // namespace unghost
