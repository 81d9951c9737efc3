// The matrix, run: modes shared out among workers, each with a device of its own.
#pragma once

#include "app/measure/stability/matrix.h"
#include "app/measure/stability_table.h"
#include "renderer/gpu/device.h"

namespace unghost {

/// What that mode's figure is worth: within the bound, over it as the mode says it may be, or neither.
StabilityCell judged(const StabilityCase& row, std::string mode, const Survival& survived);

struct StabilityRequest {
  std::vector<const StabilityCase*> cases;
  std::vector<ModeRun> modes;
  Endurance endurance = Endurance::usual;
  uint64_t seed = 1;
  std::optional<uint64_t> trial;
  DeviceRequest device;
  std::filesystem::path shaders;
  /// Our own scene on rig `drive`, for the worker of that number; it stays until all are done.
  std::function<const Film&(size_t worker)> asphalt;
  /// A worker begins with a case, and has done it; called from all of them, one at a time.
  std::function<void(std::string_view name)> begins;
  std::function<void()> ends;
};
/// How many workers there would be: one for each core that this process may use, but no more than there are
/// modes where each has some.
size_t stability_workers(const StabilityRequest& request);

struct StabilityResult {
  StabilityTable table;
  std::vector<std::string> validation_messages;
};
/// Throws what the devices throw, and Interrupted.
StabilityResult run_stability(const StabilityRequest& request);

} // namespace unghost
