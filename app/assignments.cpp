#include "app/assignments.h"

#include <algorithm>

#include "renderer/mode_names.h"

namespace unghost {
namespace {

Settings settings_of(const Settings& shared, const ModeRun& run) {
  Settings settings = shared;
  settings.taa = run.taa;
  return settings;
}

/// Whether a mode reads it. One that does not, or whose name says it, keeps its own value.
bool has_effect(const Setting& row, const std::vector<ModeRun>& modes, std::vector<Settings>& asked) {
  bool used = false;
  for (size_t i = 0; i < asked.size(); ++i)
    if (mode_says(modes[i].name, row.name))
      continue;
    else if (row.used.met_by(asked[i]))
      used = true;
    else if (row.per_mode)
      row.write(asked[i], row.read(settings_of({}, modes[i])));
  return used;
}

} // namespace

std::vector<Assignment> apply_assignments(std::span<const Assignment> assignments, Settings& shared,
                                          std::vector<ModeRun>& modes) {
  for (const Assignment& each : assignments) apply_setting(shared, each.text);
  std::vector<Settings> asked;
  for (const ModeRun& run : modes) {
    Settings& settings = asked.emplace_back(settings_of(shared, run));
    for (const Assignment& each : assignments)
      if (!mode_says(run.name, each.row().name)) apply_setting(settings, each.text);
  }
  std::vector<Assignment> unused;
  for (const Assignment& each : assignments)
    if (!has_effect(each.row(), modes, asked)) unused.push_back(each);
  for (size_t i = 0; i < asked.size(); ++i) modes[i].taa = asked[i].taa;
  return unused;
}

std::string without_effect(const Assignment& assignment, std::span<const ModeRun> modes) {
  const auto own = std::ranges::count_if(
      modes, [&](const ModeRun& run) { return mode_says(run.name, assignment.row().name); });
  const std::string text = assignment.text + " has no effect";
  if (own > 0 && size_t(own) == modes.size()) return text + ": every mode here says its own";
  return text + (own > 0 ? " on those that do not say their own: " : ": ") +
         std::string(assignment.row().used.otherwise);
}

std::optional<std::string> refusal(const Settings& shared, std::span<const ModeRun> modes) {
  for (const ModeRun& run : modes) {
    const Settings settings = settings_of(shared, run);
    if (const auto why = refusal(settings)) return run.name + ": " + *why;
    for (const std::string& change : changes_of_mode(run.name))
      if (const Assignment own{.text = change}; !own.row().used.met_by(settings))
        return run.name + ": " + without_effect(own, {});
  }
  return {};
}

} // namespace unghost
