#include "app/demo/demo_command.h"

#include <algorithm>

#include "app/shot.h"
#include "app/words.h"

namespace unghost {
namespace {

bool has_effect(const Setting& row, const Settings& settings) { return row.used.met_by(settings); }

/// Where two settings draw otherwise; null where they do not.
const Setting* difference(const Settings& a, const Settings& b) {
  for (const Setting& row : settings_table())
    if (row.read(a) != row.read(b) && (has_effect(row, a) || has_effect(row, b))) return &row;
  return nullptr;
}

/// `name=value` of what a mode has otherwise than its row, each once.
void add_assignments(const Settings& settings, const Settings& usual, Words& assignments) {
  for (const Setting& row : settings_table()) {
    if (row.read(settings) == row.read(usual) || !has_effect(row, settings)) continue;
    std::string assignment = std::string(row.name) + "=" + row.get(settings);
    if (std::ranges::count(assignments, assignment) == 0) assignments.push_back(std::move(assignment));
  }
}

Words words_of(const DemoState& state) {
  const std::vector<size_t> seen = modes_seen(state);
  const Shot usual;
  Words words = {seen.size() > 1 ? "compare" : "capture"}, names, assignments;
  for (const size_t mode : seen) {
    names.push_back(state.modes[mode].name);
    add_assignments(settings_of(state, mode), settings_for_mode(names.back()), assignments);
  }
  if (state.scene != usual.scene) words.push_back(state.scene);
  words.insert(words.end(), {seen.size() > 1 ? "--modes" : "--mode", joined(names, ",")});
  if (state.rig != usual.rig) words.insert(words.end(), {"--rig", state.rig});
  if (state.seed != usual.seed) words.insert(words.end(), {"--seed", std::to_string(state.seed)});
  for (std::string& assignment : assignments) words.insert(words.end(), {"--set", std::move(assignment)});
  words.insert(words.end(), {"-o", "unghost.png"});
  return words;
}

// Reading it is what says that a line means what is shown.
void check(const Words& words, const DemoState& state) {
  const Shot shot = shot_from(command_line_of(words));
  const std::vector<size_t> seen = modes_seen(state);
  for (size_t i = 0; i < seen.size(); ++i) {
    Settings drawn = shot.settings;
    drawn.taa = shot.modes[i].taa;
    if (const Setting* row = difference(drawn, settings_of(state, seen[i])))
      throw SettingError("no command line gives the modes that are compared unlike values of " +
                         std::string(row->name) + ", but for those of their rows");
  }
}

} // namespace

std::string command_of(const DemoState& state) {
  Words words = words_of(state);
  check(words, state);
  words.insert(words.begin(), "unghost");
  return quoted_words(words);
}

} // namespace unghost
