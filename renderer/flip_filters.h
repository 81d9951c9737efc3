// The filters of FLIP (Andersson et al. 2020), for whatever computes it: on processors to measure by, on the
// device to be seen.
#pragma once

#include <cstddef>
#include <vector>

namespace unghost {

/// 0.7 m from a monitor of 0.7 m with 3840 pixels.
inline constexpr double usual_pixels_per_degree = 67.0206432765;

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

} // namespace unghost
