// A constant scene for thousands of frames: an average in half floats must not stop short of it, nor drift.
#include <cmath>

#include "app/interruption.h"
#include "app/measure/stability/matrix.h"

namespace unghost {
namespace {

constexpr float all_alphas[] = {0.01f, 0.1f, 0.05f, 0.02f};
constexpr float targets[] = {0.1f, 1, 30, 1000, 30'000};
constexpr uint32_t side = 6, margin = 2; // of a block of one colour, and what may see the next block
constexpr uint32_t averaged = 64;        // frames, so that what rounding does from frame to frame is no error

/// Blocks beside one another: each target from below, and each from above.
ResolveInputs picture(bool of_start) {
  ResolveInputs inputs(side * uint32_t(std::size(targets)), 2 * side);
  for (uint32_t y = 0; y < inputs.height; ++y)
    for (uint32_t x = 0; x < inputs.width; ++x) {
      const float target = targets[x / side], start = y < side ? 0 : 2 * target;
      inputs.colours[inputs.at(x, y)] = glm::vec3(of_start ? start : target);
    }
  return inputs;
}

std::span<const float> alphas_of(Endurance endurance) {
  return std::span(all_alphas).first(endurance == Endurance::brief ? 1 : std::size(all_alphas));
}

std::vector<ModeRun> by_alpha(std::span<const ModeRun> modes, std::span<const float> alphas) {
  std::vector<ModeRun> runs;
  for (const ModeRun& mode : modes)
    for (const float alpha : alphas) runs.emplace_back(mode).taa.alpha = alpha;
  return runs;
}

double mean_of_block(const std::vector<glm::vec3>& colours, const ResolveInputs& inputs, size_t block) {
  const auto left = uint32_t(block % std::size(targets)) * side,
             top = uint32_t(block / std::size(targets)) * side;
  double sum = 0;
  for (uint32_t y = margin; y < side - margin; ++y)
    for (uint32_t x = margin; x < side - margin; ++x) {
      const glm::vec3 colour = colours[inputs.at(left + x, top + y)];
      sum += double(colour.x) + double(colour.y) + double(colour.z);
    }
  return sum / (3.0 * (side - 2 * margin) * (side - 2 * margin));
}

std::vector<uint32_t> checkpoints(Endurance endurance) {
  if (endurance == Endurance::brief) return {1000};
  if (endurance == Endurance::usual) return {2000, 10'000};
  return {2000, 10'000, 100'000};
}

} // namespace

std::vector<Survival> survive_constants(StabilityBench& bench, std::span<const ModeRun> modes) {
  const std::span<const float> alphas = alphas_of(bench.endurance);
  const std::vector<ModeRun> runs = by_alpha(modes, alphas);
  const ResolveInputs start = picture(true), target = picture(false);
  constexpr size_t blocks = 2 * std::size(targets);
  std::vector<Survival> survived(modes.size());
  bench.resolve.advance(start, runs, true);
  uint32_t frame = 1;
  for (const uint32_t checkpoint : checkpoints(bench.endurance)) {
    for (; frame + averaged < checkpoint; ++frame) {
      throw_if_interrupted();
      bench.resolve.advance(target, runs, false);
    }
    std::vector<double> sums(runs.size() * blocks);
    for (uint32_t n = 0; n < averaged; ++n, ++frame) {
      const auto results = bench.resolve.resolve(target, runs, false);
      for (size_t run = 0; run < runs.size(); ++run)
        for (size_t block = 0; block < blocks; ++block)
          sums[run * blocks + block] += mean_of_block(results[run], target, block);
    }
    for (size_t run = 0; run < runs.size(); ++run)
      for (size_t block = 0; block < blocks; ++block) {
        const double goal = targets[block % std::size(targets)];
        worsen(survived[run / alphas.size()], std::abs(sums[run * blocks + block] / averaged / goal - 1),
               "alpha " + std::to_string(runs[run].taa.alpha) + ", target " + std::to_string(goal) +
                   (block < std::size(targets) ? " from below" : " from above") + ", after " +
                   std::to_string(checkpoint) + " frames");
      }
  }
  return survived;
}

} // namespace unghost
