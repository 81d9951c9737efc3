#include "renderer/frame.h"

namespace unghost {
namespace {

FrameImages::OfGeometry draw_geometry(FrameGraph& graph, const FrameContext& in, ImageRef shadow_map) {
  const GBuffer gbuffer = draw_gbuffer(graph, in);
  const Lit lit = light(graph, in, gbuffer, shadow_map);
  const Motion motion = resolve_motion(graph, in, gbuffer, lit);
  return {gbuffer, motion, lit};
}

FrameImages::OfMode draw_mode(FrameGraph& graph, const FrameContext& in,
                              const FrameImages::OfGeometry& geometry, size_t place) {
  const Resolved steady = resolve_taa(
      graph, in, {.colour = geometry.lit.colour, .gbuffer = geometry.gbuffer, .motion = geometry.motion},
      place);
  const ImageRef crisp = sharpen(graph, in, steady.colour, place);
  const ImageRef picture = tonemap(graph, in, crisp);
  const ImageRef display = draw_view(graph, in,
                                     {.picture = picture,
                                      .gbuffer = geometry.gbuffer,
                                      .motion = geometry.motion,
                                      .lit = geometry.lit,
                                      .resolved = steady});
  return {.resolved = crisp, .display = display, .probe = steady.probe};
}

} // namespace

ImageRef compose(FrameGraph& graph, const ScreenInput& screen, std::span<const ImageRef> displays) {
  const bool compared = screen.arrangement == Arrangement::flip && displays.size() > 1;
  const ImageRef error =
      compared ? flip_error(graph, displays[0], displays[1]) : graph.neutral(VK_FORMAT_R32_SFLOAT);
  return compose_screen(graph, screen, displays, error);
}

FrameImages declare_frame(FrameGraph& graph, const std::deque<FrameContext>& contexts,
                          const std::vector<size_t>& geometry_of) {
  FrameImages images;
  const ImageRef shadow_map = draw_shadow_map(graph, contexts.front()); // no jitter touches it
  for (const FrameContext& in : contexts) images.geometries.push_back(draw_geometry(graph, in, shadow_map));
  const bool timed = contexts.front().timed;
  if (timed) copy_yardstick(graph, contexts.front(), images.geometries.front().lit.colour);
  for (size_t place = 0; place < geometry_of.size(); ++place) {
    const size_t geometry = geometry_of[place];
    images.modes.push_back(draw_mode(graph, contexts[geometry], images.geometries[geometry], place));
    images.modes.back().geometry = geometry;
    if (timed) graph.want(images.modes.back().resolved);
  }
  if (const auto& screen = contexts.front().screen) {
    std::vector<ImageRef> displays;
    for (const FrameImages::OfMode& mode : images.modes) displays.push_back(mode.display);
    images.screen = compose(graph, *screen, displays);
  }
  return images;
}

} // namespace unghost
