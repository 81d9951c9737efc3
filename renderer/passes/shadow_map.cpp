#include "renderer/passes/draws.h"

namespace unghost {
namespace {

constexpr VkFormat shadow_format = VK_FORMAT_D32_SFLOAT;
constexpr VkClearValue far_away{.depthStencil = {1, 0}};

std::vector<const Draw*> only(const FrameContext& in, bool moved) {
  std::vector<const Draw*> draws;
  for (const Draw* draw : in.casters)
    if ((in.moved[draw->object] != 0) == moved) draws.push_back(draw);
  return draws;
}

void draw_casters(FrameGraph& graph, const FrameContext& in, const char* name, bool moved,
                  Attachment target) {
  target.use = Use::depth_attachment;
  graph.pass({.name = name,
              .kind = PassKind::raster,
              .bindings = draw_bindings(in),
              .attachments = {target},
              .record = [&in, moved](PassCommands& commands) {
                commands.begin_rendering();
                record_draws(commands, in, only(in, moved),
                             {.vertex = "shadow.vert", .fragment = "shadow.frag", .shadow = true});
                commands.end_rendering();
              }});
}

} // namespace

ImageRef draw_shadow_map(FrameGraph& graph, const FrameContext& in) {
  const bool lights_something = in.in_view.anything && in.scene.traits.lit;
  if (!graph.needed(
          in.sun_shines && lights_something,
          {"shadow map", lights_something ? "the sun does not shine" : "the sun lights nothing in view"}))
    return {};
  const VkExtent2D side{in.shadow_texels, in.shadow_texels};
  const Cache rests =
      graph.cache("shadows of what rests", {.format = shadow_format, .extent = side}, in.shadow_version);
  if (!rests.valid) draw_casters(graph, in, "shadows of what rests", false, {rests.image, far_away});
  if (!graph.needed(in.in_view.moving_casters, {"shadows of what moves", "nothing that throws one moves"}))
    return rests.image;

  const Cache all = graph.cache("shadows", {.format = shadow_format, .extent = side}, in.shadow_version);
  CopyPass copy{.name = "copy shadows", .from = rests.image, .to = all.image};
  if (!graph.needed(!all.recent, {"shadows where nothing moved", "they are there from the frame before"}))
    copy.part = in.shadows_moved_before;
  if (!copy.part || copy.part->extent.width > 0) graph.copy(copy);
  draw_casters(graph, in, "shadows of what moves", true, {all.image, {}});
  return all.image;
}

} // namespace unghost
