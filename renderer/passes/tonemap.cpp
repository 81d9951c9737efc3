#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

ImageRef tonemap(FrameGraph& graph, const FrameContext& in, ImageRef colour) {
  const ImageRef display =
      graph.image({.name = "display", .format = VK_FORMAT_R8G8B8A8_UNORM, .extent = in.size});
  graph.compute({.name = "tone map",
                 .shader = "tonemap.comp",
                 .bindings = {uniform(FRAME_BINDING, in.constants), sampled(TONEMAP_COLOUR, colour),
                              storage_write(TONEMAP_OUT, display)},
                 .cover = in.size});
  return display;
}

} // namespace unghost
