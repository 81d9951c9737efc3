// The arithmetic of FLIP, a row at a time: loops over pixels without branches, which compilers turn into
// vectors.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace unghost {

/// Half of a filter that is symmetric or antisymmetric: weights 0, 1, ... to one side.
using HalfFilter = std::vector<float>;

/// All filters of one resolution, in pixels of it. Those of contrast sensitivity are Gaussians; that for blue
/// and yellow is the sum of two. The feature filters are a Gaussian and its two derivatives.
struct FlipFilters {
  explicit FlipFilters(double pixels_per_degree);
  HalfFilter achromatic, red_green, blue_yellow, blue_yellow_wide;
  HalfFilter gaussian, edge, point;
  size_t reach = 0; // of the widest
};

/// Planes of one picture: lightness and two opponent colours, linear (YyCxCz).
struct OpponentPlanes {
  size_t width = 0, height = 0;
  std::array<std::vector<float>, 3> planes;
};

/// Planes of `count` pixels of linear RGB from `first` on.
void opponent_from_linear(const float* rgb, size_t first, size_t count, OpponentPlanes& planes);

/// Errors of the rows from `first` on, before `last`.
void flip_rows(const OpponentPlanes& reference, const OpponentPlanes& test, const FlipFilters& filters,
               size_t first, size_t last, float* errors);

} // namespace unghost
