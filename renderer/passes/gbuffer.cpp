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
      .emissive = in.scene.traits.emissive ? image("emissive", VK_FORMAT_B10G11R11_UFLOAT_PACK32)
                                           : graph.neutral(VK_FORMAT_R16G16B16A16_SFLOAT),
      .depth = image("depth", VK_FORMAT_D32_SFLOAT_S8_UINT),
      .object_motion = in.anything_moved ? image("object motion", VK_FORMAT_R32G32B32A32_SFLOAT)
                                         : graph.neutral(VK_FORMAT_R32G32B32A32_SFLOAT),
      .object = image("object", VK_FORMAT_R32_UINT),
  };
  const VkClearValue zero{};
  std::vector<Attachment> attachments{{gbuffer.albedo, zero}, {gbuffer.normal, zero}, {gbuffer.material, zero}};
  // Every location stays where the shader has it: what is not there this frame is an image that nobody reads.
  attachments.push_back({in.scene.traits.emissive ? gbuffer.emissive : image("no emissive", VK_FORMAT_R8_UNORM), zero});
  attachments.push_back({in.anything_moved ? gbuffer.object_motion : image("no motion", VK_FORMAT_R8_UNORM), zero});
  attachments.push_back({gbuffer.object, zero});
  attachments.push_back({gbuffer.depth, zero, Use::depth_attachment});

  graph.pass({.name = "g-buffer",
              .kind = PassKind::raster,
              .bindings = draw_bindings(in),
              .attachments = std::move(attachments),
              .record = [&in](PassCommands& commands) {
                commands.begin_rendering();
                record_draws(commands, in, in.visible, DrawStyle::gbuffer);
                commands.end_rendering();
              }});
  return gbuffer;
}

}  // namespace unghost
