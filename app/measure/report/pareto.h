// Which modes are worth their time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace unghost {

/// Less is better in both.
struct CostAndError {
  double cost = 0, error = 0;
};

/// Indices of the points that no other beats: none is as good in both and better in one. By rising cost, so
/// by falling error. What is not a number is on no front.
std::vector<size_t> pareto_front(std::span<const CostAndError> points);

} // namespace unghost
