#include "renderer/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace unghost {
namespace {

/// exp(-pi^2 x^2 / b) for x = 0, 1, ... pixels.
HalfFilter gaussian_of(double b, double pixels_per_degree, size_t radius, double scale) {
  HalfFilter half(radius + 1);
  for (size_t i = 0; i <= radius; ++i) {
    const double degrees = double(i) / pixels_per_degree;
    half[i] = float(scale * std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / b));
  }
  return half;
}

double sum_of(const HalfFilter& half) {
  double sum = half[0];
  for (size_t i = 1; i < half.size(); ++i) sum += 2.0 * half[i];
  return sum;
}

/// Without the ends that add nothing to a float.
HalfFilter scaled(HalfFilter half, double by) {
  for (float& weight : half) weight = float(weight * by);
  while (half.size() > 1 && half.back() < 1e-9f) half.pop_back();
  return half;
}

} // namespace

FlipFilters::FlipFilters(double ppd) {
  constexpr double pi = std::numbers::pi, widest = 0.04;
  const auto radius = size_t(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * ppd));
  const HalfFilter a = gaussian_of(0.0047, ppd, radius, 1), rg = gaussian_of(0.0053, ppd, radius, 1);
  achromatic = scaled(a, 1 / sum_of(a)), red_green = scaled(rg, 1 / sum_of(rg));
  const HalfFilter wide = gaussian_of(0.04, ppd, radius, std::sqrt(34.1 * std::sqrt(pi / 0.04)));
  const HalfFilter narrow = gaussian_of(0.025, ppd, radius, std::sqrt(13.5 * std::sqrt(pi / 0.025)));
  const double both = std::sqrt(sum_of(wide) * sum_of(wide) + sum_of(narrow) * sum_of(narrow));
  blue_yellow_wide = scaled(wide, 1 / both), blue_yellow = scaled(narrow, 1 / both);

  const double deviation = 0.5 * 0.082 * ppd;
  const auto feature_radius = size_t(std::ceil(3 * deviation));
  double sum = 0, positive = 0, negative = 0, slope = 0;
  std::vector<double> g, second;
  for (size_t i = 0; i <= feature_radius; ++i) {
    const double x = double(i), sides = i == 0 ? 1 : 2;
    g.push_back(std::exp(-x * x / (2 * deviation * deviation)));
    second.push_back((x * x / (deviation * deviation) - 1) * g.back());
    sum += sides * g.back(), slope += x * g.back();
    (second.back() > 0 ? positive : negative) += sides * std::abs(second.back());
  }
  for (size_t i = 0; i <= feature_radius; ++i) {
    gaussian.push_back(float(g[i] / sum));
    edge.push_back(float(slope > 0 ? double(i) * g[i] / slope : 0));
    const double norm = second[i] > 0 ? positive : negative;
    point.push_back(float(norm > 0 ? second[i] / norm : 0));
  }
  reach = std::max(radius, feature_radius);
}

} // namespace unghost
