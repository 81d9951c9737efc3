#include "renderer/screen.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace unghost {
namespace {

constexpr int bar_px = 2, gap_px = 2;

/// The first cell lies left of the bar, the second has the bar before it.
std::vector<ScreenCell> split_cells(const ScreenRect& window, double split) {
  const int width = window.width, height = window.height, bar = std::min(bar_px, width);
  const int from = std::clamp(int(std::lround(split * width)) - bar / 2, 0, width - bar), to = from + bar;
  const ScreenRect left{0, 0, from, height};
  return {{.covered = left, .shown = left, .picture = window, .mode = 0},
          {.covered = {from, 0, width - from, height},
           .shown = {to, 0, width - to, height},
           .picture = window,
           .mode = 1}};
}

/// The whole picture, as large as it fits, in the middle.
ScreenRect fitted(const ScreenRect& place, const ScreenRect& window) {
  const auto scaled = [](int size, int to, int from) {
    return std::max(int(std::lround(double(size) * to / from)), 1);
  };
  int width = place.width, height = scaled(window.height, place.width, window.width);
  if (height > place.height)
    height = place.height, width = std::min(scaled(window.width, place.height, window.height), place.width);
  return {place.x + (place.width - width) / 2, place.y + (place.height - height) / 2, width, height};
}

/// Where one of two equal places along an axis lies, and what it covers.
struct Half {
  int from, size, covered_from, covered_size;
};
Half half_of(int size, bool second) {
  const int each = std::max((size - gap_px) / 2, 1), middle = size / 2;
  return second ? Half{size - each, each, middle, size - middle} : Half{0, each, 0, middle};
}

/// Two columns; of more than two, two rows. The last of three covers what the fourth would.
std::vector<ScreenCell> grid_cells(const ScreenRect& window, size_t modes) {
  const size_t count = std::min<size_t>(modes, SCREEN_PICTURES);
  std::vector<ScreenCell> cells;
  for (size_t mode = 0; mode < count; ++mode) {
    const Half across = half_of(window.width, mode % 2 == 1);
    const Half down =
        count > 2 ? half_of(window.height, mode >= 2) : Half{0, window.height, 0, window.height};
    const bool alone = mode % 2 == 0 && mode + 1 == count;
    const ScreenRect picture = fitted({across.from, down.from, across.size, down.size}, window);
    cells.push_back({.covered = {across.covered_from, down.covered_from,
                                 alone ? window.width : across.covered_size, down.covered_size},
                     .shown = picture,
                     .picture = picture,
                     .mode = mode});
  }
  return cells;
}

} // namespace

std::vector<ScreenCell> cells_of(const ScreenInput& screen, size_t modes) {
  assert(modes > 0 && screen.width > 0 && screen.height > 0);
  const ScreenRect window{0, 0, int(screen.width), int(screen.height)};
  const bool several = modes > 1;
  if (several && screen.arrangement == Arrangement::split) return split_cells(window, screen.split);
  if (several && screen.arrangement == Arrangement::grid) return grid_cells(window, modes);
  return {{.covered = window, .shown = window, .picture = window, .mode = 0}};
}

std::optional<PicturePoint> picture_point(const ScreenInput& screen, size_t modes, double x, double y) {
  for (const ScreenCell& cell : cells_of(screen, modes)) {
    const ScreenRect &shown = cell.shown, &picture = cell.picture;
    const bool inside =
        x >= shown.x && y >= shown.y && x < shown.x + shown.width && y < shown.y + shown.height;
    if (inside)
      return PicturePoint{.mode = cell.mode,
                          .at = {(x - picture.x) / picture.width, (y - picture.y) / picture.height}};
  }
  return std::nullopt;
}

namespace {

constexpr double region_share = 0.05, magnification = 7;
/// Of the picture, at most: a region in its middle then still lies beside the magnifier.
constexpr double largest_share = 0.42;
constexpr int margin_px = 4, fewest_blocks = 3;

/// The lens without its place in the window.
ScreenLens lens_of_size(const ScreenRect& picture, glm::dvec2 centre, glm::ivec2 picture_px) {
  ScreenLens lens;
  lens.block = std::max(1, int(std::lround(magnification * picture.width / picture_px.x)));
  const double share =
      std::min(region_share, largest_share * picture.width / (double(lens.block) * picture_px.x));
  const glm::ivec2 size = glm::max(glm::ivec2(glm::round(share * glm::dvec2(picture_px))), 1);
  const glm::dvec2 corner = glm::round(centre * glm::dvec2(picture_px) - glm::dvec2(size) / 2.0);
  lens.region_px = glm::clamp(glm::ivec2(corner), glm::ivec2(0), picture_px - size);
  const glm::dvec2 shown_px = glm::dvec2(picture.width, picture.height) / glm::dvec2(picture_px);
  const glm::ivec2 from(glm::floor(glm::dvec2(lens.region_px) * shown_px));
  const glm::ivec2 to(glm::ceil(glm::dvec2(lens.region_px + size) * shown_px));
  lens.region = {picture.x + from.x, picture.y + from.y, to.x - from.x, to.y - from.y};
  lens.inset = {0, 0, lens.block * size.x, lens.block * size.y};
  return lens;
}

} // namespace

std::optional<ScreenLens> lens_in(const ScreenCell& cell, const Magnifier& magnifier, glm::ivec2 picture_px) {
  if (!magnifier.shown) return std::nullopt;
  const ScreenRect &shown = cell.shown, &picture = cell.picture;
  ScreenLens lens = lens_of_size(picture, magnifier.centre, picture_px);
  ScreenRect& inset = lens.inset;
  constexpr int around = margin_px + int(SCREEN_BORDER);
  const int whole_width = inset.width;
  inset.width = std::min(inset.width, shown.width - 2 * around);
  if (inset.width < fewest_blocks * lens.block) return std::nullopt;

  const int right = shown.x + shown.width, bottom = shown.y + shown.height;
  const bool bar_after = right<picture.x + picture.width, bar_before = shown.x> picture.x;
  const bool to_the_right = bar_after || (!bar_before && magnifier.centre.x < 0.5);
  const bool below = magnifier.centre.y < 0.5;
  inset.x = to_the_right ? right - around - inset.width : shown.x + around;
  inset.y = below ? bottom - around - inset.height : shown.y + around;
  lens.region_at = {inset.x - (whole_width - inset.width) / 2, inset.y};

  constexpr int lines = int(SCREEN_BORDER + SCREEN_OUTLINE);
  const bool free = below ? lens.region.y + lens.region.height + lines <= inset.y
                          : inset.y + inset.height + lines <= lens.region.y;
  return free ? std::optional(lens) : std::nullopt;
}

} // namespace unghost
