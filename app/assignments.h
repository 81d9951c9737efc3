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

/// Sets them in what all modes share, and in the modes that they have an effect on: in others, a mode's own
/// settings stay. Returns those that have an effect on none. Throws SettingError for what is no assignment.
std::vector<Assignment> apply_assignments(std::span<const Assignment> assignments, Settings& shared,
                                          std::vector<ModeRun>& modes);
/// That it has an effect on none, and why, in a sentence.
std::string without_effect(const Assignment& assignment);
/// Which of the modes cannot be set so, and why, in a sentence; nothing where all can.
std::optional<std::string> refusal(const Settings& shared, std::span<const ModeRun> modes);

} // namespace unghost
