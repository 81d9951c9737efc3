// Two results compared: what has become better or worse than it was, beyond what the frames' own differences
// would explain.
#pragma once

#include <string>
#include <vector>

#include "app/measure/results.h"

namespace unghost {

enum class Verdict {
  better,
  worse,
  same, // no difference at all
  noise // the interval holds 0
};
std::string_view name_of(Verdict verdict);

/// One figure of one mode in both. Where the baseline is below ten units of the last decimal that is worth
/// reading (FLIP .001, trail .01, over_copy .1), the change is relative to that in place of the baseline.
struct Change {
  std::string scene, rig, mode, figure;
  uint32_t width = 0, height = 0;
  uint64_t seed = 1;
  std::vector<std::string> set; // name=value, beyond the defaults
  double before = 0, after = 0;
  double change = 0, low = 0, high = 0; // relative, with its 95% interval
  Verdict verdict = Verdict::same;
  bool regression = false; // worse, and by more than was allowed
};

struct BaselineComparison {
  double allowed_share = 0;
  std::vector<Change> changes;
  std::vector<std::string> missing; // sentences: what is in one and not in the other, what else differs
};

/// A figure may be worse by this share where nothing else is said.
constexpr double usual_allowance = 0.05;

/// Ghosting, shimmer, error, flicker and trail are the same on every run, and differ from frame to frame:
/// both are drawn from the same frames, in blocks. Times are taken as ratios to a copy of the same round, and
/// only where host, device and driver are the same; never in ms. Entries meet by scene, rig, size, seed and
/// what was set, and there by host, device, driver and settings where there are several.
BaselineComparison compared_with(const Results& baseline, const Results& now, double allowed_share);

size_t regressions(const BaselineComparison& comparison);
/// What is not the same in every sample: regressions first, then worse, better, and noise.
std::vector<Change> differences(const BaselineComparison& comparison);
/// {"allowed_share", "regressions", "changes": [...], "missing": [...]}
nlohmann::json comparison_json(const BaselineComparison& comparison);

} // namespace unghost
