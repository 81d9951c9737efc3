// What a report has found of the modes: shown beside each in the panel.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "app/measure/results.h"

namespace unghost {

/// By rig, then by mode, of our own scene and the largest size that was measured.
using MeasuredFigures = std::map<std::string, std::map<std::string, MeasuredMode>>;

/// Nothing where there is no such file, or where it is none of a report: the demo does without.
MeasuredFigures measured_figures(const std::filesystem::path& results);
/// "ghosting 0.0610, shimmer 0.0131"; empty where nothing was measured.
std::string figures_text(const MeasuredFigures& figures, const std::string& rig, const std::string& mode);

} // namespace unghost
