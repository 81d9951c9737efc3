#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

void copy_yardstick(FrameGraph& graph, const FrameContext& in, ImageRef colour) {
  const ImageRef copy =
      graph.image({.name = "copy", .format = VK_FORMAT_R16G16B16A16_SFLOAT, .extent = in.size});
  graph.pass({.name = "copy",
              .kind = PassKind::raster,
              .bindings = {sampled(COPY_COLOUR, colour)},
              .attachments = {{.image = copy, .clear = VkClearValue{}}},
              .record = [](PassCommands& commands) {
                commands.begin_rendering();
                commands.bind({.vertex = "full_screen.vert",
                               .fragment = "copy.frag",
                               .colours = commands.colour_formats(),
                               .depth = commands.depth_format()},
                              VK_NULL_HANDLE);
                vkCmdSetCullMode(commands.commands(), VK_CULL_MODE_NONE);
                vkCmdSetFrontFace(commands.commands(), VK_FRONT_FACE_COUNTER_CLOCKWISE);
                vkCmdDraw(commands.commands(), 3, 1, 0, 0);
                commands.end_rendering();
              }});
  graph.want(copy);
}

} // namespace unghost
