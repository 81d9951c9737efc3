// Widgets for the table of settings: one a row, whatever its kind.
#pragma once

#include <string>

#include "renderer/settings.h"

namespace unghost {

/// Every setting of that part: greyed where it has no effect, marked where it differs from `usual`, and reset
/// to that by a click. What does not go together is told in `message` and not taken. Returns whether
/// something changed.
bool edit_settings(Settings& settings, const Settings& usual, SettingsPart part, std::string& message);
/// Of the last widget, in lines that a person reads.
void tooltip(const std::string& text);

} // namespace unghost
