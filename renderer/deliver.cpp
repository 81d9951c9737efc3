#include "renderer/deliver.h"

#include <cassert>

#include <glm/gtc/packing.hpp>

#include "shaders/shared/taa_key.h"

namespace unghost {
namespace {

/// An image of `channels` out of texels of `stride` elements each, element by element.
template <class T, class Convert>
FloatImage floats(const FrameInput& input, const std::vector<std::byte>& bytes, uint32_t channels,
                  uint32_t stride, Convert convert) {
  FloatImage image{.width = input.width, .height = input.height, .channels = channels};
  const size_t pixels = size_t(input.width) * input.height;
  image.values.reserve(pixels * channels);
  for (size_t pixel = 0; pixel < pixels; ++pixel)
    for (uint32_t channel = 0; channel < channels; ++channel)
      image.values.push_back(convert(element<T>(bytes, pixel * stride + channel)));
  return image;
}

Image picture(uint32_t width, uint32_t height, const std::vector<std::byte>& bytes) {
  Image made{.name = {}, .width = width, .height = height, .rgba = {}};
  made.rgba.resize(bytes.size());
  std::memcpy(made.rgba.data(), bytes.data(), bytes.size());
  return made;
}

} // namespace

void ask(FrameGraph& graph, const FrameImages& images, const Wanted& wanted) {
  const FrameImages::OfMode& mode = images.modes[wanted.mode];
  const FrameImages::OfGeometry& geometry = images.geometries[mode.geometry];
  const auto read = [&](ImageRef image, VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT) {
    graph.read_back(image, aspect);
  };
  switch (wanted.what) {
  case Output::display:
    return read(mode.display);
  case Output::resolved:
    return read(mode.resolved);
  case Output::lit:
    return read(geometry.lit.colour);
  case Output::depth:
    return read(geometry.gbuffer.depth, VK_IMAGE_ASPECT_DEPTH_BIT);
  case Output::motion:
    return read(geometry.motion.motion_px);
  case Output::previous_depth:
    return read(geometry.motion.previous_depth);
  case Output::tag:
    return read(geometry.gbuffer.depth, VK_IMAGE_ASPECT_STENCIL_BIT);
  case Output::object:
    return read(geometry.gbuffer.object);
  case Output::sun_visibility:
    return read(geometry.lit.visibility);
  case Output::screen:
    assert(images.screen && "a frame without a screen has none to bring");
    return read(images.screen);
  }
}

Delivered deliver(const FrameInput& input, Output what, const std::vector<std::byte>& bytes) {
  const auto same = [](float value) { return value; };
  Delivered delivered;
  switch (what) {
  case Output::display:
    delivered.picture = picture(input.width, input.height, bytes);
    break;
  case Output::screen:
    delivered.picture = picture(input.screen->width, input.screen->height, bytes);
    break;
  case Output::resolved:
  case Output::lit:
    delivered.image =
        floats<uint16_t>(input, bytes, 3, 4, [](uint16_t half) { return glm::unpackHalf1x16(half); });
    break;
  case Output::depth: {
    const float near_plane = float(input.now.near_plane);
    delivered.image = floats<float>(input, bytes, 1, 1, [&](float depth) { return near_plane / depth; });
    break;
  }
  case Output::motion:
    delivered.image = floats<float>(input, bytes, 2, 2, same);
    break;
  case Output::previous_depth:
    delivered.image = floats<float>(input, bytes, 1, 1, same);
    break;
  case Output::tag:
    delivered.image = floats<uint8_t>(input, bytes, 1, 1, [](uint8_t tag) { return float(tag); });
    break;
  case Output::object:
    delivered.image =
        floats<uint32_t>(input, bytes, 1, 1, [](uint32_t word) { return float(word & OBJECT_NODE); });
    break;
  case Output::sun_visibility:
    delivered.image = floats<uint8_t>(input, bytes, 1, 1, [](uint8_t share) { return float(share) / 255; });
    break;
  }
  return delivered;
}

} // namespace unghost
