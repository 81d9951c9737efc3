#include "renderer/taa_modes.h"

#include <algorithm>

namespace unghost {
namespace {

constexpr Reject leaves_screen = Reject::off_screen;

constexpr TaaMode rows[] = {
    {"off", "The frame as it is drawn: no jitter, no history, every edge aliased.", "", {}},
    {"blend",
     "Exponential average of reprojected frames and nothing against ghosts: what every other mode must beat.",
     "GDK sample, clamping off",
     {.jitter = Jitter::halton_8, .reject = leaves_screen, .blend = Blend::constant}},
    {"gdk-clamp",
     "History clamped to the box of the 3x3 neighbourhood.",
     "GDK sample, RGB clamp",
     {.jitter = Jitter::halton_8,
      .rectify = Rectify::box_clamp,
      .reject = leaves_screen,
      .blend = Blend::constant}},
    {"uncharted",
     "Box clamp, and history rejected where the vehicle tag differs from last frame's.",
     "Naughty Dog 2016, as in The Grand Tour Game (simple)",
     {.jitter = Jitter::halton_8,
      .dilation = Dilation::closest_depth,
      .history = HistoryFilter::catmull_rom,
      .rectify = Rectify::box_clamp,
      .reject = leaves_screen | Reject::tag,
      .blend = Blend::constant}},
    {"grand-tour",
     "As uncharted, and untagged pixels that are near and moving give up their history, too.",
     "The Grand Tour Game (complex)",
     {.jitter = Jitter::halton_8,
      .dilation = Dilation::closest_depth,
      .history = HistoryFilter::catmull_rom,
      .rectify = Rectify::box_clamp,
      .reject = leaves_screen | Reject::tag | Reject::near_moving,
      .blend = Blend::constant}},
};

} // namespace

std::span<const TaaMode> taa_modes() { return rows; }

const TaaMode* find_taa_mode(std::string_view name) {
  const auto found = std::ranges::find(rows, name, &TaaMode::name);
  return found == std::end(rows) ? nullptr : &*found;
}

} // namespace unghost
