#include "app/measure/report/pareto.h"

#include <algorithm>
#include <cmath>

namespace unghost {
namespace {

bool is_cheaper(const CostAndError& a, const CostAndError& b) {
  return a.cost + a.cost_margin < b.cost - b.cost_margin;
}

bool is_known(const CostAndError& a) { return !std::isnan(a.cost) && !std::isnan(a.error); }

bool beats(const CostAndError& a, const CostAndError& b) {
  if (a.error < b.error) return !is_cheaper(b, a);
  return a.error == b.error && is_cheaper(a, b);
}

} // namespace

/// Who beats has less error, or as much and less cost: from the least error on, and beaten only by those that
/// are on the front themselves, because margins that meet make no chain.
std::vector<size_t> pareto_front(std::span<const CostAndError> points) {
  std::vector<size_t> order, front;
  for (size_t i = 0; i < points.size(); ++i)
    if (is_known(points[i])) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](size_t i) { return std::pair(points[i].error, points[i].cost); });
  for (const size_t i : order)
    if (std::ranges::none_of(front, [&](size_t kept) { return beats(points[kept], points[i]); }))
      front.push_back(i);
  std::ranges::stable_sort(front, {}, [&](size_t i) { return std::pair(points[i].cost, -points[i].error); });
  return front;
}

} // namespace unghost
