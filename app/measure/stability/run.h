// The matrix, run: modes shared out among workers, each with a device of its own.
#pragma once

#include "app/measure/stability/matrix.h"
#include "app/measure/stability_table.h"
#include "renderer/gpu/device.h"

namespace unghost {

/// What one mode came to in one case; `mode` is `all` where they share what the case is about.
struct StabilityCell {
  const StabilityCase* row = nullptr;
  std::string mode;
  Survival survived;

  bool passed() const { return survived.figure <= row->bound; }
  /// Over the bound as the mode says it may be; nothing where it is not.
  const Excuse* excuse() const;
  bool failed() const { return !passed() && excuse() == nullptr; }
};

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
  /// A worker begins with a case; called from all of them, one at a time.
  std::function<void(std::string_view name)> begins;
};
/// How many workers there would be: one for each core that this process may use, but no more than there are
/// modes.
size_t stability_workers(const StabilityRequest& request);

struct StabilityResult {
  DeviceFacts device;
  std::vector<StabilityCell> cells; // case by case, mode by mode
  std::vector<std::string> validation_messages;
};
/// Throws what the devices throw, and Interrupted.
StabilityResult run_stability(const StabilityRequest& request);
StabilityTable table_of(const StabilityRequest& request, const StabilityResult& result);

} // namespace unghost
