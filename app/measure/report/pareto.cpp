#include "app/measure/report/pareto.h"

#include <algorithm>
#include <cmath>

namespace unghost {

std::vector<size_t> pareto_front(std::span<const CostAndError> points) {
  std::vector<size_t> order;
  for (size_t i = 0; i < points.size(); ++i)
    if (!std::isnan(points[i].cost) && !std::isnan(points[i].error)) order.push_back(i);
  std::ranges::stable_sort(order, {}, [&](size_t i) { return std::pair(points[i].cost, points[i].error); });
  std::vector<size_t> front;
  for (const size_t i : order) {
    const bool better = front.empty() || points[i].error < points[front.back()].error;
    const bool alike = !front.empty() && points[i].error == points[front.back()].error &&
                       points[i].cost == points[front.back()].cost;
    if (better || alike) front.push_back(i);
  }
  return front;
}

} // namespace unghost
