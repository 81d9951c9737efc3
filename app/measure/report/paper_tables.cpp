#include "app/measure/report/paper_tables.h"

#include <cassert>
#include <cmath>
#include <filesystem>

namespace unghost {

std::span<const PaperTable> paper_tables() {
  static constexpr PaperRow grass[] = {
      {"RGB", "rgb", 0.449, 0.0346, 0.0499},
      {"YCoCg", "ycocg", 0.452, 0.0344, 0.0538},
      {"32-DOP", "dop32", 0.662, 0.0433, 0.0399},
      {"16-DOP+Opt", "dop16-opt", 0.538, 0.0491, 0.0374},
      {"RGB+Var", "rgb-var", 0.465, 0.0406, 0.0417},
      {"YCoCg+Var", "ycocg-var", 0.451, 0.0411, 0.0448},
      {"32-DOP+Var", "dop32-var", 0.665, 0.0568, 0.0336},
  };
  static constexpr PaperRow asphalt[] = {
      {"RGB", "rgb", 0.428, 0.0111, 0.0520},
      {"YCoCg", "ycocg", 0.465, 0.0117, 0.0319},
      {"32-DOP", "dop32", 0.635, 0.0120, 0.0321},
      {"16-DOP+Opt", "dop16-opt", 0.528, 0.0130, 0.0300},
      {"RGB+Var", "rgb-var", 0.466, 0.0116, 0.0439},
      {"YCoCg+Var", "ycocg-var", 0.466, 0.0134, 0.0289},
      {"32-DOP+Var", "dop32-var", 0.653, 0.0144, 0.0286},
  };
  static constexpr PaperTable tables[] = {
      {"Table 1, grass", "grass", "kick", grass},
      {"Table 2, asphalt", "asphalt", "drive", asphalt},
  };
  return tables;
}

bool is_of(const PaperTable& table, const Measured& measured) {
  return std::filesystem::path(measured.scene).stem() == table.scene && measured.rig == table.rig;
}

OrderComparison compare_orders(std::span<const double> theirs, std::span<const double> ours) {
  assert(theirs.size() == ours.size());
  OrderComparison found;
  for (size_t a = 0; a < theirs.size(); ++a)
    for (size_t b = a + 1; b < theirs.size(); ++b) {
      const double there = theirs[a] - theirs[b], here = ours[a] - ours[b];
      if (std::isnan(there) || std::isnan(here)) continue;
      ++found.pairs;
      if (there == 0 || here == 0)
        ++found.tied;
      else if ((there < 0) == (here < 0))
        ++found.alike;
      else
        found.unlike.emplace_back(a, b);
    }
  return found;
}

} // namespace unghost
