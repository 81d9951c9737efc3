// Names of rows with settings of their own: `rgb:alpha=0.05:reject=off-screen+tag`. Commas part modes, so the
// words of a list are joined by `+`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unghost {

/// "rgb".
std::string base_of_mode(std::string_view name);
/// {"alpha=0.05", "reject=off-screen,tag"}: what its row is not set to, as --set takes it. Nothing is
/// checked.
std::vector<std::string> changes_of_mode(std::string_view name);
/// Whether that is the jitter and no more: times are taken without one, where such a row is no other.
bool changes_only_jitter(std::string_view name);
/// Whether the name says a setting of that name, "alpha".
bool mode_says(std::string_view name, std::string_view setting);

} // namespace unghost
