// Settings that are asked for, over those that are there.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/settings.h"

namespace unghost {

/// One setting that was asked for, by --set or by a settings file.
struct Assignment {
  std::string text; // name=value
  bool of_file = false;

  const Setting& row() const { return find_setting(text.substr(0, text.find('='))); }
};

/// Sets them in what all modes share, and in the modes that they have an effect on and that do not say the
/// setting in their names: in others, a mode's own settings stay. Returns those that have an effect on none.
/// Throws SettingError for what is no assignment.
std::vector<Assignment> apply_assignments(std::span<const Assignment> assignments, Settings& shared,
                                          std::vector<ModeRun>& modes);
/// That it has an effect on none of them, and why, in a sentence.
std::string without_effect(const Assignment& assignment, std::span<const ModeRun> modes);
/// Which of the modes cannot be set so, or says what has no effect then, and why, in a sentence; nothing
/// where all is well.
std::optional<std::string> refusal(const Settings& shared, std::span<const ModeRun> modes);

} // namespace unghost
