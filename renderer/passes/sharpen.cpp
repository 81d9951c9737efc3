#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

ImageRef sharpen(FrameGraph& graph, const FrameContext& in, ImageRef colour, size_t place) {
  const float amount = in.modes[place].taa.sharpen;
  if (!graph.needed(amount != 0, {"sharpen", "sharpen is 0"})) return colour;
  const ImageRef crisp =
      graph.image({.name = "crisp", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = in.size});
  const auto bytes = std::as_bytes(std::span(&amount, 1));
  graph.compute({.name = "sharpen " + in.modes[place].name,
                 .shader = "sharpen.comp",
                 .bindings = {uniform(FRAME_BINDING, in.constants), storage_read(SHARPEN_COLOUR, colour),
                              storage_write(SHARPEN_OUT, crisp)},
                 .push = {bytes.begin(), bytes.end()},
                 .cover = in.size});
  return crisp;
}

} // namespace unghost
