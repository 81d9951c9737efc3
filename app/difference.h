// Where two pictures differ most.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/scene/scene.h"

namespace unghost {

/// In pixels from the top left.
struct Window {
  uint32_t x = 0, y = 0, width = 0, height = 0;

  bool operator==(const Window&) const = default;
};

/// The `count` windows of that size with the largest difference, best first, none overlapping another. Means
/// over 4x4 pixels are compared, so that a ghost counts and lost texture hardly does. The pictures have one
/// size; fewer windows come back where no more fit.
std::vector<Window> windows_of_difference(const Image& a, const Image& b, uint32_t width, uint32_t height,
                                          size_t count);

} // namespace unghost
