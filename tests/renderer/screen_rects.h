// Where rectangles of a window lie to one another.
#pragma once

#include "renderer/screen.h"

namespace unghost {

constexpr glm::ivec2 window_sizes[] = {{1, 1}, {2, 9}, {37, 23}, {320, 180}, {480, 270}, {961, 541}};

inline int right_of(const ScreenRect& rect) { return rect.x + rect.width; }
inline int bottom_of(const ScreenRect& rect) { return rect.y + rect.height; }
inline bool is_in(const ScreenRect& rect, double x, double y) {
  return x >= rect.x && y >= rect.y && x < right_of(rect) && y < bottom_of(rect);
}
inline bool is_in(const ScreenRect& inner, const ScreenRect& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && right_of(inner) <= right_of(outer) &&
         bottom_of(inner) <= bottom_of(outer);
}
inline ScreenRect grown(const ScreenRect& rect, uint32_t by) {
  const int more = int(by);
  return {rect.x - more, rect.y - more, rect.width + 2 * more, rect.height + 2 * more};
}
inline bool overlap(const ScreenRect& a, const ScreenRect& b) {
  return a.x < right_of(b) && b.x < right_of(a) && a.y < bottom_of(b) && b.y < bottom_of(a);
}

} // namespace unghost
