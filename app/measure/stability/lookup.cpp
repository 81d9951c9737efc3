// Where a history is read: to a hundredth of a pixel, however small or large the motion.
#include <cmath>

#include "app/interruption.h"
#include "app/measure/stability/matrix.h"
#include "shaders/shared/frame.h"

namespace unghost {
namespace {

constexpr uint32_t width = 64, height = 256; // so many rows average what half floats round
constexpr uint32_t margin = 8;
constexpr float slope = 1.0f / 16, level = 1; // of a ramp, a pixel

/// A ramp whose content has come from `motion` away.
ResolveInputs ramp(float motion) {
  ResolveInputs inputs(width, height);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      inputs.colours[inputs.at(x, y)] = glm::vec3(level + slope * (float(x) + motion));
  inputs.motion.assign(inputs.motion.size(), {motion, 0});
  return inputs;
}

/// Mean of the columns' distances from where they should have been read, pixels.
double error_px(const std::vector<glm::vec3>& found, float motion) {
  double most = 0;
  for (uint32_t x = margin; x < width - margin; ++x) {
    double sum = 0;
    for (uint32_t y = 0; y < height; ++y) sum += double(found[size_t(y) * width + x].x);
    const double expected = double(level) + double(slope) * (double(x) + double(motion));
    most = std::max(most, std::abs(sum / height - expected) / double(slope));
  }
  return most;
}

} // namespace

std::vector<Survival> look_up_histories(StabilityBench& bench, std::span<const ModeRun> modes) {
  std::vector<ModeRun> runs(modes.begin(), modes.end());
  for (ModeRun& run : runs) run.taa.alpha = 0;
  std::vector<Survival> survived(modes.size());
  for (const float motion : {0.0f, 1e-6f, -1e-6f, 0.5f, 1.0f, -1.0f, 2.25f}) {
    throw_if_interrupted();
    bench.resolve.advance(ramp(0), runs, true);
    const auto results = bench.resolve.resolve(ramp(motion), runs, false);
    for (size_t mode = 0; mode < runs.size(); ++mode)
      if (runs[mode].taa.policy.history != HistoryFilter::nearest)
        worsen(survived[mode], error_px(results[mode], motion),
               "motion of " + std::to_string(motion) + " px");
  }
  ResolveInputs dark(width, height), light(width, height);
  dark.colours.assign(dark.colours.size(), glm::vec3(0.1f));
  light.colours.assign(light.colours.size(), glm::vec3(0.875f)); // which half floats have
  for (const glm::vec2 off :
       {glm::vec2(1e4f, 0), glm::vec2(-1e4f, 0), glm::vec2(0, 1e4f), glm::vec2(0, -1e4f)}) {
    light.motion.assign(light.motion.size(), off);
    bench.resolve.advance(dark, runs, true);
    const auto moved = bench.resolve.resolve(light, runs, false),
               fresh = bench.resolve.resolve(light, runs, true);
    for (size_t mode = 0; mode < runs.size(); ++mode)
      if (moved[mode] != fresh[mode])
        worsen(survived[mode], INFINITY, "motion off the picture is no history");
  }
  // what has no motion has no history, also for those that reject nothing
  for (ModeRun& run : runs) run.taa.policy.reject = Reject::nothing;
  light.motion.assign(light.motion.size(), glm::vec2(float(MOTION_UNKNOWN)));
  bench.resolve.advance(dark, runs, true);
  const auto unknown = bench.resolve.resolve(light, runs, false);
  for (size_t mode = 0; mode < runs.size(); ++mode)
    if (unknown[mode] != light.colours) worsen(survived[mode], INFINITY, "no motion is no history");
  return survived;
}

} // namespace unghost
