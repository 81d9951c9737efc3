// How a mode looks in charts: a family by colour, a member by shape. Never colour alone.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/measure/results.h"

namespace unghost {

/// `family` is an index of families(), and the page's colour class "f" + index; `shape` counts within it.
struct Look {
  int family = 0, shape = 0;
};
constexpr int shape_count = 6;

std::span<const std::string_view> families();
/// Of every mode of all scenes: its family by its settings and not by its name.
std::map<std::string, Look> looks_of(const Results& results);
/// The inside of an SVG: a mark of that shape around a point, `radius` pixels large.
std::string svg_shape(int shape, double x, double y, double radius);
/// A small SVG of its own, for tables and keys.
std::string svg_glyph(const Look& look);

} // namespace unghost
