#include "renderer/passes/passes.h"
#include "shaders/shared/bindings.h"

namespace unghost {

ImageRef draw_view(FrameGraph& graph, const FrameContext& in, const ViewInputs& inputs) {
  const View view = in.view;
  if (!graph.needed(view != View::colour, {"view", "the picture itself is shown"})) return inputs.picture;

  const ImageRef out = graph.image({.name = "view", .format = VK_FORMAT_R8G8B8A8_UNORM, .extent = in.size});
  // What this view does not look at is neutral, so that nothing is made for it.
  const auto only = [&](std::initializer_list<View> views, ImageRef image, VkFormat otherwise) {
    for (const View one : views)
      if (one == view) return image;
    return graph.neutral(otherwise);
  };
  constexpr VkFormat colour = VK_FORMAT_R8G8B8A8_UNORM;
  const bool tags = view == View::tag && in.scene.traits.tagged;
  constexpr VkFormat hdr = VK_FORMAT_R16G16B16A16_SFLOAT;
  const auto of_resolve = [&](std::initializer_list<View> views, ImageRef image, VkFormat format) {
    return only(views, image ? image : graph.neutral(format), format);
  };
  const ImageRef why = of_resolve({View::weight, View::rectified, View::tag_rejected, View::near_moving,
                                   View::rejected, View::age, View::pixel_class},
                                  inputs.resolved.why, colour);
  const ImageRef history = of_resolve({View::history}, inputs.resolved.history, hdr);
  graph.compute(
      {.name = "view",
       .shader = "view.comp",
       .constants = {uint32_t(view), uint32_t(bool(inputs.resolved.why))},
       .bindings =
           {uniform(FRAME_BINDING, in.constants),
            sampled(VIEW_PICTURE,
                    only({View::colour, View::motion, View::tag, View::rectified, View::tag_rejected,
                          View::near_moving, View::rejected, View::pixel_class},
                         inputs.picture, colour)),
            sampled(VIEW_ALBEDO, only({View::albedo}, inputs.gbuffer.albedo, colour)),
            sampled(VIEW_NORMAL, only({View::normal}, inputs.gbuffer.normal, VK_FORMAT_R32G32_SFLOAT)),
            sampled(VIEW_DEPTH, only({View::depth, View::normal, View::albedo}, inputs.gbuffer.depth,
                                     VK_FORMAT_R32_SFLOAT)),
            sampled(VIEW_MOTION, only({View::motion}, inputs.motion.motion_px, VK_FORMAT_R32G32_SFLOAT)),
            tags ? sampled_stencil(VIEW_TAG, inputs.gbuffer.depth)
                 : sampled(VIEW_TAG, graph.neutral(VK_FORMAT_R8_UINT)),
            sampled(VIEW_VISIBILITY, only({View::shadow}, inputs.lit.visibility, VK_FORMAT_R8_UNORM)),
            sampled(VIEW_IRRADIANCE, only({View::light_channel}, inputs.lit.irradiance, VK_FORMAT_R8_UINT)),
            sampled(VIEW_WHY, why), sampled(VIEW_HISTORY, history),
            sampled(VIEW_LIT, only({View::volume}, inputs.lit.colour, hdr)), storage_write(VIEW_OUT, out)},
       .cover = in.size});
  return out;
}

} // namespace unghost
