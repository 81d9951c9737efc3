#include <bit>
#include <cassert>

#include "renderer/flip_filters.h"
#include "renderer/passes/passes.h"
#include "shaders/shared/flip.h"

namespace unghost {
namespace {

uint32_t weight_of(const HalfFilter& half, size_t tap) {
  return std::bit_cast<uint32_t>(tap < half.size() ? half[tap] : 0.0f);
}

std::vector<Constant> weights() {
  const FlipFilters f(usual_pixels_per_degree);
  assert(f.reach < FLIP_TAPS);
  std::vector<Constant> constants;
  for (size_t tap = 0; tap < FLIP_TAPS; ++tap)
    for (const HalfFilter* half :
         {&f.achromatic, &f.red_green, &f.blue_yellow, &f.blue_yellow_wide, &f.gaussian, &f.edge, &f.point})
      constants.emplace_back(weight_of(*half, tap));
  return constants;
}

std::vector<std::byte> pushed(VkExtent2D size) {
  const glm::ivec2 size_px(size.width, size.height);
  const auto bytes = std::as_bytes(std::span(&size_px, 1));
  return {bytes.begin(), bytes.end()};
}

struct Filtered {
  ImageRef colours, features;
};

Filtered filter_down(FrameGraph& graph, ImageRef display) {
  const VkExtent2D size = graph.desc(display).extent;
  const auto image = [&](const char* name) {
    return graph.image({.name = name, .format = VK_FORMAT_R32G32B32A32_SFLOAT, .extent = size});
  };
  const Filtered filtered{.colours = image("FLIP colours"), .features = image("FLIP features")};
  graph.compute(
      {.name = "FLIP down",
       .shader = "flip_down.comp",
       .constants = weights(),
       .bindings = {storage_read(FLIP_DISPLAY, display), storage_write(FLIP_COLOURS, filtered.colours),
                    storage_write(FLIP_FEATURES, filtered.features)},
       .push = pushed(size),
       .cover = size,
       .group = {WORKGROUP_WIDTH, FLIP_BAND_ROWS}});
  return filtered;
}

} // namespace

ImageRef flip_error(FrameGraph& graph, ImageRef reference, ImageRef test) {
  const VkExtent2D size = graph.desc(reference).extent;
  const Filtered first = filter_down(graph, reference), second = filter_down(graph, test);
  const ImageRef error = graph.image({.name = "FLIP", .format = VK_FORMAT_R32_SFLOAT, .extent = size});
  graph.compute(
      {.name = "FLIP across",
       .shader = "flip_across.comp",
       .constants = weights(),
       .bindings = {storage_read(FLIP_COLOURS, first.colours), storage_read(FLIP_FEATURES, first.features),
                    storage_read(FLIP_TEST_COLOURS, second.colours),
                    storage_read(FLIP_TEST_FEATURES, second.features), storage_write(FLIP_OUT, error)},
       .push = pushed(size),
       .cover = size,
       .group = {FLIP_GROUP_BANDS * FLIP_BAND_COLUMNS, FLIP_GROUP_ROWS}});
  return error;
}

} // namespace unghost
