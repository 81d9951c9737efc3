#include "renderer/passes/draws.h"

namespace unghost {

GBuffer draw_gbuffer(FrameGraph& graph, const FrameContext& in) {
  const auto image = [&](const char* name, VkFormat format) {
    return graph.image({.name = name, .format = format, .extent = in.size});
  };
  const GBuffer gbuffer{
      .albedo = image("albedo", VK_FORMAT_R8G8B8A8_UNORM),
      .normal = image("normal", VK_FORMAT_R16G16_SNORM),
      .material = image("material", VK_FORMAT_R8G8B8A8_UNORM),
      .emissive = image("emissive", VK_FORMAT_B10G11R11_UFLOAT_PACK32),
      .depth = image("depth", VK_FORMAT_D32_SFLOAT_S8_UINT),
      .object_motion = image("object motion", VK_FORMAT_R32G32B32A32_SFLOAT),
      .object = image("object", VK_FORMAT_R32_UINT),
  };
  const VkClearValue zero{};
  std::vector<Attachment> attachments;
  for (const ImageRef target : {gbuffer.albedo, gbuffer.normal, gbuffer.material})
    attachments.push_back({.image = target, .clear = zero, .together = true});
  for (const ImageRef target : {gbuffer.emissive, gbuffer.object_motion, gbuffer.object})
    attachments.push_back({target, zero});
  attachments.push_back({gbuffer.depth, zero, Use::depth_attachment});

  graph.pass({.name = "g-buffer",
              .kind = PassKind::raster,
              .bindings = draw_bindings(in),
              .attachments = std::move(attachments),
              .record = [&in, gbuffer](PassCommands& commands) {
                commands.begin_rendering();
                // shaders/gbuffer.frag is compiled for every set of outputs that there may be
                std::string fragment = "gbuffer.frag";
                if (commands.live(gbuffer.albedo)) fragment += ".shading";
                if (commands.live(gbuffer.emissive)) fragment += ".emissive";
                if (commands.live(gbuffer.object_motion)) fragment += ".motion";
                if (commands.live(gbuffer.object)) fragment += ".object";
                record_draws(commands, in, in.visible,
                             {.vertex = "gbuffer.vert",
                              .fragment = fragment,
                              .features = (in.shifts_textures ? SHIFTS_TEXTURES : 0u) |
                                          (in.biases_textures ? BIASES_TEXTURES : 0u)});
                commands.end_rendering();
              }});
  return gbuffer;
}

} // namespace unghost
