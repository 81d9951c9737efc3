// The arithmetic of FLIP, a row at a time: loops over pixels without branches, which compilers turn into
// vectors.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "app/measure/flip.h"
#include "renderer/flip_filters.h"

namespace unghost {

/// Planes of a picture's rows from `top` on: lightness and two opponent colours, linear (YyCxCz). A row
/// starts `stride` after the one above it: more than a narrow picture's width, as vectors are read whole.
struct OpponentPlanes {
  OpponentPlanes(size_t width, size_t height);
  size_t width, height, stride, top = 0;
  std::array<std::vector<float>, 3> planes;
};

/// A row from its linear RGB, counted from the top.
void opponent_row(const float* rgb, size_t row, OpponentPlanes& to);

/// The picture's rows from `first` on, before `last`. The planes hold all rows that their filters reach, but
/// for those beyond the picture.
void see_rows(const OpponentPlanes& planes, const FlipFilters& filters, size_t first, size_t last,
              SeenPicture& out);

/// Errors of `count` pixels from `first` on.
void compare_pixels(const SeenPicture& reference, const SeenPicture& test, size_t first, size_t count,
                    float* errors);

} // namespace unghost
