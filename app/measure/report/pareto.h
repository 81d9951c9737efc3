// Which modes are worth their time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace unghost {

/// Less is better in both.
struct CostAndError {
  double cost = 0, error = 0;
  double cost_margin = 0; // within which the cost is known
};

/// Indices of the points that no other beats: as good in both and better in one. Costs whose margins meet are
/// as good as each other; errors only where they are equal. By rising cost. What is not a number is on no
/// front.
std::vector<size_t> pareto_front(std::span<const CostAndError> points);

} // namespace unghost
