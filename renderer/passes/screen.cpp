#include <cmath>

#include "renderer/passes/passes.h"
#include "shaders/shared/screen.h"

namespace unghost {
namespace {

constexpr float bar_grey = 1, gap_grey = 0.06f;

uint32_t what_shows(Arrangement arrangement) {
  switch (arrangement) {
  case Arrangement::difference:
    return SCREEN_SHOWS_DIFFERENCE;
  case Arrangement::flip:
    return SCREEN_SHOWS_ERROR;
  default:
    return SCREEN_SHOWS_PICTURE;
  }
}

struct Scaling {
  uint32_t how = SCREEN_COPIED;
  uint32_t columns = 1, rows = 1; // of the picture, that the pixels of one invocation are made from
};

Scaling scaling_of(VkExtent2D picture, const ScreenRect& place) {
  const double across = double(picture.width) / place.width, down = double(picture.height) / place.height;
  if (across == 1 && down == 1) return {};
  const bool reduced = across > 1 || down > 1;
  // what a kernel of so many texels around one pixel, and around all pixels of an invocation, touches at most
  const auto texels = [&](double scale, uint32_t pixels) {
    const double kernel = reduced ? std::max(scale, 1.0) + 1 : 4;
    return uint32_t(std::ceil(kernel + scale * (pixels - 1)));
  };
  return {.how = reduced ? SCREEN_REDUCED : SCREEN_ENLARGED,
          .columns = texels(across, 1),
          .rows = texels(down, SCREEN_ROWS)};
}

ComputePass draw_cell(const ScreenCell& cell, const ScreenInput& screen, VkExtent2D picture) {
  const auto lens = lens_in(cell, screen.magnifier, {picture.width, picture.height});
  const ScreenLens placed = lens.value_or(ScreenLens{});
  const ScreenPush push{.covered = cell.covered,
                        .shown = cell.shown,
                        .picture = cell.picture,
                        .inset = placed.inset,
                        .region = placed.region,
                        .region_px = placed.region_px,
                        .region_at = placed.region_at,
                        .picture_px = {picture.width, picture.height},
                        .block = placed.block,
                        .beside = screen.arrangement == Arrangement::split ? bar_grey : gap_grey};
  const auto bytes = std::as_bytes(std::span(&push, 1));
  const Scaling scaling = scaling_of(picture, cell.picture);
  return {.name = {},
          .shader = "screen.comp",
          .constants = {uint32_t(cell.mode), what_shows(screen.arrangement), scaling.how, scaling.columns,
                        scaling.rows, uint32_t(lens.has_value())},
          .bindings = {},
          .push = {bytes.begin(), bytes.end()},
          .cover = {uint32_t(cell.covered.width), uint32_t(cell.covered.height)},
          .group = {WORKGROUP_WIDTH, SCREEN_ROWS}};
}

} // namespace

ImageRef compose_screen(FrameGraph& graph, const ScreenInput& given, std::span<const ImageRef> displays,
                        ImageRef error) {
  ScreenInput screen = given;
  if (displays.size() == 1) screen.arrangement = Arrangement::single;
  const VkExtent2D picture = graph.desc(displays.front()).extent, size{screen.width, screen.height};
  const bool same_size = picture.width == size.width && picture.height == size.height;
  if (screen.arrangement == Arrangement::single && same_size && !screen.magnifier.shown)
    return displays.front();

  const ImageRef out = graph.image({.name = "screen", .format = VK_FORMAT_R8G8B8A8_UNORM, .extent = size});
  std::vector<ComputePass> dispatches; // beside one another: none waits for another
  size_t seen = screen.arrangement == Arrangement::difference ? 2 : 1;
  for (const ScreenCell& cell : cells_of(screen, displays.size())) {
    seen = std::max(seen, cell.mode + 1);
    if (cell.covered.width > 0 && cell.covered.height > 0)
      dispatches.push_back(draw_cell(cell, screen, picture));
  }
  const auto seen_or_first = [&](size_t mode) { return displays[mode < seen ? mode : 0]; };
  graph.pass({.name = "screen",
              .bindings = {storage_read(SCREEN_PICTURE_0, displays[0]),
                           storage_read(SCREEN_PICTURE_1, seen_or_first(1)),
                           storage_read(SCREEN_PICTURE_2, seen_or_first(2)),
                           storage_read(SCREEN_PICTURE_3, seen_or_first(3)),
                           storage_read(SCREEN_ERROR, error), storage_write(SCREEN_OUT, out)},
              .record = [dispatches](PassCommands& commands) {
                for (const ComputePass& cell : dispatches) commands.dispatch(cell);
              }});
  return out;
}

} // namespace unghost
