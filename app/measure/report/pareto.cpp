#include "app/measure/report/pareto.h"

#include <algorithm>
#include <cmath>

namespace unghost {
namespace {

bool is_cheaper(const CostAndError& a, const CostAndError& b) {
  return a.cost + a.cost_margin < b.cost - b.cost_margin;
}

bool is_known(const CostAndError& a) { return !std::isnan(a.cost) && !std::isnan(a.error); }

/// No circle of points beats itself: who beats has less error, or as much and is cheaper.
bool beats(const CostAndError& a, const CostAndError& b) {
  if (a.error < b.error) return !is_cheaper(b, a);
  return a.error == b.error && is_cheaper(a, b);
}

} // namespace

std::vector<size_t> pareto_front(std::span<const CostAndError> points) {
  const auto is_beaten = [&](const CostAndError& point) {
    return std::ranges::any_of(
        points, [&](const CostAndError& other) { return is_known(other) && beats(other, point); });
  };
  std::vector<size_t> front;
  for (size_t i = 0; i < points.size(); ++i)
    if (is_known(points[i]) && !is_beaten(points[i])) front.push_back(i);
  std::ranges::stable_sort(front, {}, [&](size_t i) { return std::pair(points[i].cost, -points[i].error); });
  return front;
}

} // namespace unghost
