// What Ikkala et al. 2024, "k-DOP Clipping: Robust Ghosting Mitigation in Temporal Antialiasing", measured,
// and how its order of methods compares with ours.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "app/measure/results.h"

namespace unghost {

struct PaperRow {
  std::string_view method, mode; // the paper's name, and ours
  double ms = 0, shimmer = 0, ghosting = 0;
};
struct PaperTable {
  std::string_view title;
  std::string_view scene, rig; // of ours that show the same
  std::span<const PaperRow> rows;
};
/// Tables 1 and 2. The first row of each is the one that its times are compared with.
std::span<const PaperTable> paper_tables();

/// Whether it shows what the table does.
bool is_of(const PaperTable& table, const Measured& measured);

/// Of all pairs: as in Kendall's rank correlation.
struct OrderComparison {
  size_t pairs = 0, alike = 0;
  size_t tied = 0;                               // in one of them or both: no order to compare
  std::vector<std::pair<size_t, size_t>> unlike; // in one order there, in the other here
};
/// Pairs of which a figure is missing (not a number) are not counted. Both have the same length.
OrderComparison compare_orders(std::span<const double> theirs, std::span<const double> ours);

} // namespace unghost
