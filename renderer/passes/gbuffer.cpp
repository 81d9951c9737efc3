#include <algorithm>

#include "renderer/passes/draws.h"
#include "shaders/shared/bindings.h"

namespace unghost {
namespace {

/// What there is, and because of what the rest is left out.
void decide(FrameGraph& graph, const FrameContext& in, GBuffer& g) {
  const SceneTraits& traits = in.scene.traits;
  g.surfaces = graph.needed(in.in_view.anything, {"g-buffer", "nothing is in view"},
                            {g.albedo, g.normal, g.material, g.emissive, g.depth, g.object_motion, g.object});
  if (!g.surfaces) return;
  g.lit = graph.needed(traits.lit, {"light on surfaces", "every material is unlit"},
                       {g.albedo, g.normal, g.material});
  g.shines = graph.needed(traits.emissive, {"emissive", "no material shines"}, {g.emissive});
  g.moves = graph.needed(in.in_view.anything_moved, {"object motion", "no object in view moves"},
                         {g.object_motion});
  const bool asked =
      std::ranges::any_of(in.modes, [](const ModeRun& run) { return run.taa.policy.needs_tags(); });
  g.tagged = graph.needed(traits.tagged && asked,
                          {"tags", traits.tagged ? "this mode asks for none" : "no object is tagged"});
}

/// shaders/gbuffer.frag is compiled for every set of outputs that there may be.
DrawStyle style_of(const PassCommands& commands, const GBuffer& gbuffer, bool plain) {
  DrawStyle style{
      .vertex = "gbuffer.vert", .fragment = "gbuffer.frag", .tags = commands.stencil_live(gbuffer.depth)};
  if (plain) style.written = ~(1u << GBUFFER_EMISSIVE | 1u << GBUFFER_MOTION);
  if (commands.live(gbuffer.albedo)) style.fragment += ".shading";
  if (commands.live(gbuffer.emissive) && !plain) style.fragment += ".emissive";
  if (commands.live(gbuffer.object_motion) && !plain) style.fragment += ".motion";
  if (commands.live(gbuffer.object)) style.fragment += ".object";
  return style;
}

} // namespace

GBuffer draw_gbuffer(FrameGraph& graph, const FrameContext& in) {
  const auto image = [&](const char* name, VkFormat format) {
    return graph.image({.name = name, .format = format, .extent = in.size});
  };
  GBuffer gbuffer{
      .albedo = image("albedo", VK_FORMAT_R8G8B8A8_UNORM),
      .normal = image("normal", VK_FORMAT_R16G16_SNORM),
      .material = image("material", VK_FORMAT_R8G8B8A8_UNORM),
      .emissive = image("emissive", VK_FORMAT_B10G11R11_UFLOAT_PACK32),
      .depth = image("depth", VK_FORMAT_D32_SFLOAT_S8_UINT),
      .object_motion = image("object motion", VK_FORMAT_R32G32B32A32_SFLOAT),
      .object = image("object ids", VK_FORMAT_R32_UINT),
  };
  decide(graph, in, gbuffer);
  const bool spares =
      !graph.needed(in.plain == 0 || !(gbuffer.shines || gbuffer.moves),
                    {"emissive and motion of what has none", "it is drawn before the rest, over zeros"});
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
              .record = [&in, gbuffer, spares](PassCommands& commands) {
                const std::span<const Draw* const> all(in.visible);
                const size_t plain = spares ? in.plain : 0;
                commands.begin_rendering();
                record_draws(commands, in, all.first(plain), style_of(commands, gbuffer, true));
                record_draws(commands, in, all.subspan(plain), style_of(commands, gbuffer, false));
                commands.end_rendering();
              }});
  return gbuffer;
}

} // namespace unghost
