// Medians and other quantiles of measured times.
#pragma once

#include <algorithm>
#include <vector>

namespace unghost {

/// The value that this share of all are not above; the nearest where it falls between two; 0 of none.
template <class T> T quantile(std::vector<T> values, double share) {
  if (values.empty()) return T(0);
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1) + 0.5);
  std::ranges::nth_element(values, at);
  return *at;
}

} // namespace unghost
