#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

Lit light(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer, ImageRef shadow_map) {
  const Lit lit{
      .colour = graph.image({.name = "lit", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = in.size}),
      .visibility = graph.image({.name = "sun visibility", .format = VK_FORMAT_R8_UNORM, .extent = in.size}),
      .irradiance = graph.image({.name = "irradiance", .format = VK_FORMAT_R8_UINT, .extent = in.size})};
  const bool sun = gbuffer.lit && shadow_map;
  const auto read_if = [&](bool is, uint32_t slot, ImageRef image) {
    return sampled(slot, is ? image : graph.neutral(VK_FORMAT_R16G16B16A16_SFLOAT));
  };
  graph.compute(
      {.name = "light",
       .shader = "light.comp",
       .constants = {uint32_t(gbuffer.shines), gbuffer.lit ? in.light_count : 0u, lit.visibility,
                     uint32_t(gbuffer.surfaces), uint32_t(gbuffer.lit), uint32_t(sun), lit.irradiance},
       .bindings = {uniform(FRAME_BINDING, in.constants), read_if(gbuffer.lit, LIGHT_ALBEDO, gbuffer.albedo),
                    read_if(gbuffer.lit, LIGHT_NORMAL, gbuffer.normal),
                    read_if(gbuffer.lit, LIGHT_MATERIAL, gbuffer.material),
                    read_if(gbuffer.shines, LIGHT_EMISSIVE, gbuffer.emissive),
                    read_if(gbuffer.surfaces, LIGHT_DEPTH, gbuffer.depth),
                    read_if(sun, LIGHT_SHADOW_MAP, shadow_map), buffer(LIGHT_LIGHTS, in.lights),
                    storage_write(LIGHT_OUT, lit.colour), storage_write(LIGHT_VISIBILITY_OUT, lit.visibility),
                    storage_write(LIGHT_IRRADIANCE_OUT, lit.irradiance)},
       .cover = in.size});
  return lit;
}

} // namespace unghost
