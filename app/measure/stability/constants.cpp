// A constant scene for thousands of frames: an average in half floats must not stop short of it, nor drift.
#include <cmath>

#include <glm/gtc/packing.hpp>

#include "app/interruption.h"
#include "app/measure/stability/matrix.h"
#include "app/measure/stability_table.h"

namespace unghost {
namespace {

constexpr float all_alphas[] = {0.01f, 0.1f, 0.05f, 0.02f};
constexpr float targets[] = {0.1f, 1, 30, 1000, 30'000};
constexpr uint32_t side = 9, margin = 2; // of a block of one target, and what may see the next block
constexpr uint32_t averaged = 64;        // frames, so that what rounding does from frame to frame is no error

enum class Kind { from_below, from_above, spread };

/// In every 3x3 there are two pixels that spread its colours so far that no history is bounded, and seven of
/// which an average is judged.
Kind kind_of(uint32_t x, uint32_t y) {
  if (x % 3 == y % 3 && x % 3 < 2) return Kind::spread;
  return (x + y) % 2 == 0 ? Kind::from_above : Kind::from_below;
}

/// What a pixel of that target shows for ever, as half floats have it. A history begins at the target itself.
float goal_of(float target, uint32_t x, uint32_t y) {
  const Kind kind = kind_of(x, y);
  const float share = kind == Kind::from_below   ? 1.25f
                      : kind == Kind::from_above ? 0.75f
                      : x % 3 == 0               ? 0.25f
                                                 : 1.75f;
  return glm::unpackHalf1x16(glm::packHalf1x16(target * share));
}

ResolveInputs picture(bool of_start) {
  ResolveInputs inputs(side * uint32_t(std::size(targets)), side);
  for (uint32_t y = 0; y < inputs.height; ++y)
    for (uint32_t x = 0; x < inputs.width; ++x) {
      const float target = targets[x / side];
      inputs.colours[inputs.at(x, y)] = glm::vec3(of_start ? target : goal_of(target, x, y));
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

/// Of all pixels of that kind in a block, as a share of their goal.
double mean_share(const std::vector<glm::vec3>& colours, const ResolveInputs& inputs, size_t block,
                  Kind kind) {
  double sum = 0, goals = 0;
  for (uint32_t y = margin; y < side - margin; ++y)
    for (uint32_t inner = margin; inner < side - margin; ++inner) {
      const uint32_t x = uint32_t(block) * side + inner;
      if (kind_of(x, y) != kind) continue;
      const glm::vec3 colour = colours[inputs.at(x, y)];
      sum += double(colour.x) + double(colour.y) + double(colour.z);
      goals += 3 * double(inputs.colours[inputs.at(x, y)].x);
    }
  return sum / goals;
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
  const ResolveInputs start = picture(true), goal = picture(false);
  constexpr size_t judged = 2 * std::size(targets); // each target from below, and each from above
  const auto kind = [](size_t i) { return i % 2 == 0 ? Kind::from_below : Kind::from_above; };
  std::vector<Survival> survived(modes.size());
  bench.resolve.advance(start, runs, true);
  uint32_t frame = 1;
  for (const uint32_t checkpoint : checkpoints(bench.endurance)) {
    for (; frame + averaged < checkpoint; ++frame) {
      throw_if_interrupted();
      bench.resolve.advance(goal, runs, false);
    }
    std::vector<double> sums(runs.size() * judged);
    for (uint32_t n = 0; n < averaged; ++n, ++frame) {
      const auto results = bench.resolve.resolve(goal, runs, false);
      for (size_t i = 0; i < sums.size(); ++i)
        sums[i] += mean_share(results[i / judged], goal, i % judged / 2, kind(i));
    }
    for (size_t i = 0; i < sums.size(); ++i)
      worsen(survived[i / judged / alphas.size()], std::abs(sums[i] / averaged - 1),
             "alpha " + value_text(double(runs[i / judged].taa.alpha)) + ", " +
                 value_text(double(targets[i % judged / 2])) + " from " +
                 (kind(i) == Kind::from_below ? "below" : "above") + ", after " + std::to_string(checkpoint) +
                 " frames");
  }
  return survived;
}

} // namespace unghost
