// A measurement as words ask for it: what `measure`, a job of a sweep and a report have in common.
#pragma once

#include <filesystem>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/measure/protocols.h"
#include "app/measure/results.h"
#include "app/progress.h"
#include "app/shot.h"

namespace unghost {

/// Everything that decides a measurement; the modes with the jitter that all share. Throws WrongWords and
/// SettingError where the words are wrong.
struct MeasurePlan {
  explicit MeasurePlan(const CommandLine& line);

  CommandLine line;
  Shot shot;
  Protocol protocol;
  std::set<Aspect> aspects;
};

/// As work_of counts, a pixel of 640x360.
double work_of(const MeasurePlan& plan);

/// Draws and measures. Kept frames are written to `folder`, which is made; it is not used where none are
/// asked for. Throws what drawing throws, and Failure(failed) where the validation layer complained.
Measured measured_by(const MeasurePlan& plan, const std::filesystem::path& folder, Console& console,
                     Progress& progress);

} // namespace unghost
