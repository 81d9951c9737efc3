#include "app/measure/report/labels.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace unghost {
namespace {

double overlap(const Area& a, const Area& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

double outside(const Area& a, const Area& within) {
  return std::max(0., within.left - a.left) + std::max(0., a.right - within.right) +
         std::max(0., within.top - a.top) + std::max(0., a.bottom - within.bottom);
}

struct Candidate {
  Area area;
  double cost = 0; // of being there at all
  bool far = false;
};

/// Around the point, nearest first; right and left are read most easily.
std::vector<Candidate> candidates(const Label& label) {
  const double width = text_width(label), half = label_size / 2;
  std::vector<Candidate> all;
  const auto add = [&](double left, double middle, double cost, bool far) {
    all.push_back({{left, middle - half, left + width, middle + half}, cost, far});
  };
  for (const double gap : {8., 18., 30., 44.}) {
    const bool far = gap > 18;
    const double cost = gap - 8;
    add(label.x + gap, label.y, cost, far), add(label.x - gap - width, label.y, cost + 2, far);
    for (const double up : {-1., 1.}) {
      const double y = label.y + up * (gap + half - 1);
      add(label.x - width / 2, y, cost + 3, far);
      add(label.x + 4, y, cost + 3, far), add(label.x - width - 4, y, cost + 4, far);
    }
  }
  return all;
}

} // namespace

double text_width(const Label& label) {
  size_t characters = 0;
  for (const char c : label.text) characters += (c & 0xc0) != 0x80; // of UTF-8
  return (label.bold ? 0.68 : 0.61) * label_size * double(characters);
}

std::vector<PlacedLabel> place_labels(const std::vector<Label>& labels, const std::vector<Area>& taken,
                                      const Area& within) {
  std::vector<Area> blocked = taken;
  std::vector<PlacedLabel> placed;
  for (const Label& label : labels) {
    double least = INFINITY;
    Candidate best;
    for (const Candidate& candidate : candidates(label)) {
      double cost = candidate.cost + 40 * outside(candidate.area, within);
      for (const Area& area : blocked) cost += overlap(candidate.area, area);
      if (cost < least) least = cost, best = candidate;
    }
    blocked.push_back(best.area);
    placed.push_back({best.area.left, best.area.bottom - 0.22 * label_size, best.far});
  }
  return placed;
}

std::vector<PlacedLabel> place_at_ends(const std::vector<Label>& labels) {
  constexpr double apart = label_size + 1;
  std::vector<size_t> order(labels.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::ranges::stable_sort(order, {}, [&](size_t i) { return labels[i].y; });
  std::vector<double> middle;
  for (const Label& label : labels) middle.push_back(label.y);
  for (int round = 0; round < 400; ++round) // neighbours push each other away, each as far
    for (size_t i = 1; i < order.size(); ++i) {
      double &above = middle[order[i - 1]], &below = middle[order[i]];
      const double lack = apart - (below - above);
      if (lack > 0.05) above -= lack / 2, below += lack / 2;
    }
  std::vector<PlacedLabel> placed;
  for (size_t i = 0; i < labels.size(); ++i)
    placed.push_back(
        {labels[i].x + 14, middle[i] + 0.28 * label_size, std::abs(middle[i] - labels[i].y) > 3});
  return placed;
}

} // namespace unghost
