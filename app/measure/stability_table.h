// What the matrix of stiff and extreme cases came to, as plain data: what `unghost stability` writes and a
// report reads.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace unghost {

/// One case of the matrix: what it asks of a mode, and the most that may come of it.
struct StabilityColumn {
  std::string name, summary, unit;
  double bound = 0;
};

constexpr const char* every_mode = "all";

/// One mode in one case; `mode` is `every_mode` where the modes share what the case is about.
struct StabilityCell {
  std::string mode, column;
  std::optional<double> value; // none where it is no number, which is over any bound
  std::string worst;           // where that was
  std::string excuse;          // why it may be over the bound, where it is and may be
  bool pass = false;           // at most the bound, or excused
};

struct StabilityTable {
  std::string version, device, driver, endurance;
  uint64_t seed = 1;
  std::vector<StabilityColumn> columns;
  std::vector<StabilityCell> cells; // column by column, mode by mode
};

/// The figure of that mode and column, or the one that all modes share. Nothing where there is none.
const StabilityCell* find_cell(const StabilityTable& table, const std::string& mode,
                               const std::string& column);
/// The worst in a column of those that need no excuse. Nothing where there is none.
const StabilityCell* worst_cell(const StabilityTable& table, const std::string& column);
/// How many cells a whole matrix of these modes and columns has that are not there.
size_t missing_cells(const StabilityTable& table);
/// By name, in the order of the cells.
std::vector<std::string> modes_of(const StabilityTable& table);
/// "0.00529", "2.4e-04", "0", "broken".
std::string value_text(const std::optional<double>& value);

nlohmann::json stability_json(const StabilityTable& table);
/// Throws Failure(input_refused), which begins with `where`.
StabilityTable stability_from_json(const nlohmann::json& object, const std::string& where);

} // namespace unghost
