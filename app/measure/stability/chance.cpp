// Whatever comes: settings, sizes, light and cameras by chance, the same ones for the same seed.
#include <algorithm>
#include <cmath>
#include <random>

#include "app/interruption.h"
#include "app/measure/stability/block_world.h"
#include "app/measure/stability/matrix.h"

namespace unghost {
namespace {

class Chance {
public:
  explicit Chance(uint64_t seed) : random_(seed) {}
  uint32_t below(uint32_t count) { return uint32_t((uint64_t(random_()) * count) >> 32); }
  bool one_in(uint32_t count) { return below(count) == 0; }
  /// Often an end of the range.
  double between(double low, double high) {
    if (one_in(6)) return one_in(2) ? low : high;
    return low + (high - low) * double(random_()) / 4294967295.0;
  }

private:
  std::mt19937 random_; // its numbers are the standard's; the standard's distributions are not
};

void set_by_chance(Chance& chance, const Setting& row, Settings& settings) {
  Settings changed = settings;
  if (row.kind == SettingKind::number)
    row.write(changed, chance.between(double(row.low), double(row.high)));
  else if (row.kind == SettingKind::choice)
    row.write(changed, row.answers[chance.below(uint32_t(row.answers.size()))].value);
  if (!refusal(changed)) settings = changed;
}

/// Numbers of any mode; answers, each of which makes a pipeline, more seldom.
ModeRun mode_by_chance(Chance& chance, std::span<const ModeRun> modes, bool any_answers) {
  ModeRun run = modes[chance.below(uint32_t(modes.size()))];
  Settings settings;
  settings.taa = run.taa;
  const bool answers = any_answers && chance.one_in(20);
  for (const Setting& row : settings_table())
    if (row.per_mode && (row.kind == SettingKind::number ? chance.one_in(3) : answers && chance.one_in(3)))
      set_by_chance(chance, row, settings);
  run.taa = settings.taa;
  return run;
}

void light_by_chance(Chance& chance, Settings& settings) {
  for (const Setting& row : settings_table())
    if (!row.per_mode && row.kind == SettingKind::number && chance.one_in(4))
      set_by_chance(chance, row, settings);
}

/// A camera that may be anywhere (braces: the order of chances is that of the words), look anywhere, and see
/// little or nearly all.
void jolt(Chance& chance, Instant& instant) {
  const auto one = [&] { return chance.between(-1, 1); };
  const double far = std::pow(10, chance.between(-2, 4));
  instant.eye += glm::dvec3{one(), one(), one()} * far;
  instant.camera = glm::normalize(instant.camera * glm::dquat{1, one(), one(), one()});
  instant.vertical_fov = chance.between(0.02, 2.9);
  instant.near_plane = std::pow(10, chance.between(-4, 2));
}

struct Trial {
  std::vector<FrameInput> frames;
  bool asphalt = false; // of our own scene, not of the blocks'
};

Trial trial_of(const StabilityBench& bench, std::span<const ModeRun> modes, uint64_t number) {
  Chance chance(bench.seed * 1'000'003 + number);
  Trial trial;
  trial.asphalt = chance.one_in(12) && bench.endurance != Endurance::brief; // it takes seconds to load
  std::vector<ModeRun> runs;
  for (uint32_t count = 1 + chance.below(3); count > 0; --count)
    runs.push_back(mode_by_chance(chance, modes, !trial.asphalt));
  Settings settings;
  light_by_chance(chance, settings);
  const uint32_t start = chance.below(2000);
  uint32_t width = 1 + chance.below(48), height = 1 + chance.below(32);
  for (uint32_t i = 0; i < 3; ++i) {
    FrameInput input = trial.asphalt ? bench.asphalt().at(start + i) : block_drive(start + i);
    if (chance.one_in(3)) jolt(chance, input.now);
    if (i > 0) input.before = trial.frames.back().now;
    if (chance.one_in(8)) width = 1 + chance.below(48), height = 1 + chance.below(32);
    input.cut = i == 0 || chance.one_in(8);
    input.index = chance.one_in(4) ? chance.below(1u << 30) : start + i;
    input.width = width, input.height = height;
    input.settings = settings, input.modes = runs;
    for (size_t mode = 0; mode < runs.size(); ++mode) input.wanted.push_back({Output::resolved, mode});
    trial.frames.push_back(std::move(input));
  }
  return trial;
}

/// What draws that trial again.
std::string command_of(const StabilityBench& bench, std::span<const ModeRun> modes, uint64_t number) {
  std::string words = "unghost stability --case chance --seed " + std::to_string(bench.seed) + " --trial " +
                      std::to_string(number);
  if (bench.endurance == Endurance::brief) words += " --brief";
  if (modes.size() == stability_modes().size()) return words;
  for (size_t i = 0; i < modes.size(); ++i) words += (i == 0 ? " --modes " : ",") + modes[i].name;
  return words;
}

} // namespace

std::vector<Survival> survive_chance(StabilityBench& bench, std::span<const ModeRun> modes) {
  std::vector<Survival> survived(modes.size());
  const uint64_t trials = bench.endurance == Endurance::brief   ? 60
                          : bench.endurance == Endurance::usual ? 2000
                                                                : 50'000;
  constexpr uint64_t trials_of_a_renderer = 400; // whose pipelines have other answers by chance, and add up
  uint64_t drawn = 0;
  for (uint64_t turn = bench.trial ? 0 : bench.share; turn < (bench.trial ? 1 : trials);
       turn += bench.shares) {
    const uint64_t number = bench.trial.value_or(turn);
    throw_if_interrupted();
    if (++drawn % trials_of_a_renderer == 0) bench.blocks = block_renderer(bench.device, bench.shaders);
    const Trial trial = trial_of(bench, modes, number);
    for (const FrameInput& input : trial.frames) {
      const FrameResult result = trial.asphalt ? bench.asphalt().draw(input) : bench.blocks.render(input);
      for (size_t i = 0; i < input.modes.size(); ++i) {
        const auto mode = std::ranges::find(modes, input.modes[i].name, &ModeRun::name);
        Survival& so_far = survived[size_t(mode - modes.begin())];
        if (const size_t wrong = wrong_values(result.delivered[i].image); double(wrong) > so_far.figure)
          worsen(so_far, double(wrong), command_of(bench, modes, number));
      }
    }
  }
  return survived;
}

} // namespace unghost
