#include "app/baseline_table.h"

#include <algorithm>
#include <cmath>

#include "app/table.h"

namespace unghost {
namespace {

std::string percent(double share) {
  const std::string text = fixed(std::abs(100 * share), 1);
  return (share < 0 ? "-" : "+") + text + "%";
}

std::string scene_of(const Change& change) {
  std::string text = change.scene;
  for (const std::string& assignment : change.set) text += " " + assignment;
  return text;
}

Table table_of(const std::vector<Change>& changes) {
  Table table{{"scene", "rig", "size", "seed", "mode", "figure", "before", "after", "change", "95% from",
               "to", "verdict"}};
  for (const Change& change : changes) {
    const auto kind = std::ranges::find(figure_kinds(), change.figure, &FigureKind::name);
    const auto value = [&](double of) { return fixed(of, kind->decimals); };
    table.add({scene_of(change), change.rig,
               std::to_string(change.width) + "x" + std::to_string(change.height),
               std::to_string(change.seed), change.mode, change.figure, value(change.before),
               value(change.after), percent(change.change), percent(change.low), percent(change.high),
               change.regression ? "REGRESSION" : std::string(name_of(change.verdict))});
  }
  return table;
}

} // namespace

std::string comparison_text(const BaselineComparison& comparison) {
  const std::vector<Change> changed = differences(comparison);
  std::string text = changed.empty() ? "" : table_of(changed).text();
  text += std::to_string(comparison.changes.size() - changed.size()) + " of " +
          std::to_string(comparison.changes.size()) + " figures are the same in every sample; " +
          std::to_string(regressions(comparison)) + " are worse by more than " +
          fixed(100 * comparison.allowed_share, 1) + "%\n";
  for (const std::string& sentence : comparison.missing) text += sentence + "\n";
  return text;
}

} // namespace unghost
