#include "assets/generator/curve.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace unghost::author {

using glm::dvec2;

Curve::Curve(std::initializer_list<dvec2> keys) : keys_(keys), second_(keys.size(), 0.0) {
  assert(keys_.size() >= 2);
  // The tridiagonal system of the natural spline, solved downwards and back up.
  std::vector<double> upper(keys_.size(), 0.0);
  for (size_t i = 1; i + 1 < keys_.size(); ++i) {
    const dvec2 before = keys_[i] - keys_[i - 1], after = keys_[i + 1] - keys_[i];
    const double ratio = before.x / (before.x + after.x);
    const double pivot = ratio * upper[i - 1] + 2;
    upper[i] = (ratio - 1) / pivot;
    const double bend = 6 * (after.y / after.x - before.y / before.x) / (before.x + after.x);
    second_[i] = (bend - ratio * second_[i - 1]) / pivot;
  }
  for (size_t i = keys_.size() - 1; i-- > 0;) second_[i] = upper[i] * second_[i + 1] + second_[i];
}

double Curve::operator()(double x) const {
  const auto above =
      std::upper_bound(keys_.begin(), keys_.end(), x, [](double v, dvec2 k) { return v < k.x; });
  const size_t high = std::clamp<size_t>(size_t(above - keys_.begin()), 1, keys_.size() - 1), low = high - 1;
  const double h = keys_[high].x - keys_[low].x, slope = (keys_[high].y - keys_[low].y) / h;
  if (x < keys_.front().x) return keys_[0].y + (x - keys_[0].x) * (slope - h * second_[1] / 6);
  if (x > keys_.back().x) return keys_[high].y + (x - keys_[high].x) * (slope + h * second_[low] / 6);
  const double a = (keys_[high].x - x) / h, b = 1 - a;
  return a * keys_[low].y + b * keys_[high].y +
         ((a * a * a - a) * second_[low] + (b * b * b - b) * second_[high]) * h * h / 6;
}

Outline::Outline(std::vector<dvec2> corners) : corners_(std::move(corners)) { assert(corners_.size() >= 3); }

Outline Outline::smooth(const std::vector<dvec2>& points) {
  std::vector<dvec2> corners;
  const size_t n = points.size();
  for (size_t i = 0; i < n; ++i) {
    const dvec2 a = points[(i + n - 1) % n], b = points[i], c = points[(i + 1) % n], d = points[(i + 2) % n];
    for (int step = 0; step < 6; ++step) {
      const double t = step / 6.0;
      corners.push_back(0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                               (3.0 * b - a - 3.0 * c + d) * t * t * t));
    }
  }
  return Outline(corners);
}

Outline Outline::rounded(std::vector<dvec2> corners, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    std::vector<dvec2> cut;
    for (size_t i = 0; i < corners.size(); ++i) {
      const dvec2 a = corners[i], b = corners[(i + 1) % corners.size()];
      // Not more than 6 cm off a corner: long sides stay straight.
      const double length = glm::length(b - a), keep = std::min(0.25, 0.06 / length / (round + 1));
      cut.push_back(glm::mix(a, b, keep));
      cut.push_back(glm::mix(b, a, keep));
    }
    corners = cut;
  }
  return Outline(corners);
}

double Outline::distance(dvec2 p) const {
  double nearest = 1e9;
  bool inside = false;
  for (size_t i = 0; i < corners_.size(); ++i) {
    const dvec2 a = corners_[i], b = corners_[(i + 1) % corners_.size()];
    const dvec2 side = b - a, to = p - a;
    const double along = std::clamp(glm::dot(to, side) / glm::dot(side, side), 0.0, 1.0);
    nearest = std::min(nearest, glm::length(to - along * side));
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * side.x) inside = !inside;
  }
  return inside ? -nearest : nearest;
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double bell(double x, double width) { return std::exp(-(x / width) * (x / width)); }

} // namespace unghost::author
