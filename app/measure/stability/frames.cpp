// Whole frames of a small scene: sizes, settings at their ends, cuts, and thousands in a row.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/interruption.h"
#include "app/measure/stability/block_world.h"
#include "app/measure/stability/matrix.h"

namespace unghost {
namespace {

using Values = std::vector<FloatImage>; // what each mode resolved

FrameInput at(uint32_t frame, std::span<const ModeRun> modes) {
  FrameInput input = block_drive(frame);
  input.width = 64, input.height = 36;
  input.modes.assign(modes.begin(), modes.end());
  for (size_t mode = 0; mode < modes.size(); ++mode) input.wanted.push_back({Output::resolved, mode});
  return input;
}

Values drawn(StabilityBench& bench, const FrameInput& input) {
  throw_if_interrupted();
  FrameResult result = bench.blocks.render(input);
  Values values;
  for (Delivered& one : result.delivered) values.push_back(std::move(one.image));
  return values;
}

double most_apart(const FloatImage& a, const FloatImage& b) {
  if (a.values.size() != b.values.size()) return INFINITY;
  double most = 0;
  for (size_t i = 0; i < a.values.size(); ++i) {
    if (!std::isfinite(a.values[i]) || !std::isfinite(b.values[i])) return INFINITY;
    most = std::max(most, std::abs(double(a.values[i]) - double(b.values[i])));
  }
  return most;
}

std::string text_of(uint32_t width, uint32_t height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

} // namespace

std::vector<Survival> survive_sizes(StabilityBench& bench, std::span<const ModeRun> modes) {
  constexpr std::array<uint32_t, 2> sizes[] = {{1, 1}, {1, 720}, {4097, 3}, {33, 17},
                                               {2, 2}, {65, 9},  {7, 257}};
  std::vector<Survival> survived(modes.size());
  uint32_t frame = 0;
  for (const bool every_frame : {false, true})
    for (const auto& [width, height] : sizes)
      for (int again = 0; again < (every_frame ? 1 : 2); ++again, ++frame) {
        FrameInput input = at(frame, modes);
        input.width = width, input.height = height;
        const Values values = drawn(bench, input);
        for (size_t mode = 0; mode < modes.size(); ++mode) {
          const bool right = values[mode].width == width && values[mode].height == height;
          worsen(survived[mode], right ? double(wrong_values(values[mode])) : INFINITY,
                 text_of(width, height));
        }
      }
  for (int again = 0; again < 3; ++again, ++frame) {
    FrameInput input = at(frame, modes);
    input.now.camera = glm::angleAxis(1.5, glm::dvec3(1, 0, 0)); // up, where there is only sky
    if (again > 0) input.before.camera = input.now.camera;
    const Values values = drawn(bench, input);
    for (size_t mode = 0; mode < modes.size(); ++mode)
      worsen(survived[mode], double(wrong_values(values[mode])), "nothing in view");
  }
  return survived;
}

namespace {

struct AtItsEnd {
  size_t mode;
  ModeRun run; // named by the setting
};

/// Every number of a mode at both ends of its range, and thresholds that cross.
std::vector<AtItsEnd> settings_at_their_ends(std::span<const ModeRun> modes) {
  std::vector<AtItsEnd> runs;
  const auto add = [&](size_t mode, const std::string& name, const Settings& settings) {
    if (!refusal(settings)) runs.push_back({mode, {name, settings.taa}}); // refused in a sentence: as good
  };
  for (size_t mode = 0; mode < modes.size(); ++mode) {
    Settings base;
    base.taa = modes[mode].taa;
    for (const Setting& row : settings_table()) {
      if (!row.per_mode || row.kind != SettingKind::number) continue;
      if (!row.used.met_by(base)) continue;
      for (const float end : {row.low, row.high}) {
        Settings settings = base;
        row.write(settings, end);
        add(mode, std::string(row.name) + "=" + row.get(settings), settings);
      }
    }
    Settings crossed = base;
    crossed.taa.near_m = 10, crossed.taa.far_m = 5;
    add(mode, "near beyond far", crossed);
  }
  return runs;
}

} // namespace

std::vector<Survival> survive_settings(StabilityBench& bench, std::span<const ModeRun> modes) {
  const std::vector<AtItsEnd> ends = settings_at_their_ends(modes);
  constexpr size_t at_once = 32;
  std::vector<Survival> survived(modes.size());
  for (size_t first = 0; first < ends.size(); first += at_once) {
    std::vector<ModeRun> runs;
    for (size_t i = first; i < std::min(first + at_once, ends.size()); ++i) runs.push_back(ends[i].run);
    for (uint32_t frame = 0; frame < 4; ++frame) {
      const Values values = drawn(bench, at(frame, runs));
      for (size_t i = 0; i < runs.size(); ++i)
        worsen(survived[ends[first + i].mode], double(wrong_values(values[i])), runs[i].name);
    }
  }
  return survived;
}

namespace {

/// What those frames come to, of which the first is a cut.
Values afresh(StabilityBench& bench, const std::vector<FrameInput>& frames) {
  Values last;
  for (size_t i = 0; i < frames.size(); ++i) {
    FrameInput input = frames[i];
    input.cut = i == 0;
    last = drawn(bench, input);
  }
  return last;
}

/// Some frames, a pause, a step of 10 s and one back: no cut, so that all of it may be in the history.
void step_by_any_length(StabilityBench& bench, std::span<const ModeRun> modes,
                        std::vector<Survival>& survived) {
  FrameInput last;
  for (const uint32_t frame : {0u, 1u, 2u, 3u, 3u, 3u, 603u, 1u}) {
    FrameInput input = at(60 + frame, modes);
    if (!last.modes.empty()) input.before = last.now, input.index = last.index + 1;
    last = input;
    const Values values = drawn(bench, input);
    for (size_t mode = 0; mode < modes.size(); ++mode)
      if (wrong_values(values[mode]) > 0) worsen(survived[mode], INFINITY, "a step of any length");
  }
}

/// Somewhere else, at once; the frame after it shows what the cut left behind.
void cut_to(StabilityBench& bench, uint32_t frame, std::span<const ModeRun> modes, const char* what,
            std::vector<Survival>& survived) {
  FrameInput cut = at(frame, modes);
  const FrameInput next = at(frame + 1, modes);
  cut.cut = true;
  drawn(bench, cut);
  const Values found = drawn(bench, next), fresh = afresh(bench, {cut, next});
  for (size_t mode = 0; mode < modes.size(); ++mode)
    worsen(survived[mode], most_apart(found[mode], fresh[mode]), what);
}

/// Another mode at every place, every frame: none may read the history of another.
void take_turns(StabilityBench& bench, std::span<const ModeRun> modes, std::vector<Survival>& survived) {
  for (uint32_t frame = 0; frame < 6; ++frame) {
    std::vector<ModeRun> turned(modes.begin(), modes.end());
    std::ranges::rotate(turned, turned.begin() + ptrdiff_t(frame % modes.size()));
    FrameInput input = at(90 + frame, turned);
    const Values found = drawn(bench, input);
    if (frame == 0) continue;
    input.cut = true;
    const Values fresh = drawn(bench, input);
    for (size_t place = 0; place < modes.size(); ++place) {
      const size_t mode = (place + frame) % modes.size(), before = (mode + modes.size() - 1) % modes.size();
      if (modes[mode].taa.policy != modes[before].taa.policy) // else the history is its own
        worsen(survived[mode], most_apart(found[place], fresh[place]), "modes in turns");
    }
  }
}

} // namespace

std::vector<Survival> survive_cuts(StabilityBench& bench, std::span<const ModeRun> modes) {
  std::vector<Survival> survived(modes.size());
  step_by_any_length(bench, modes, survived);
  cut_to(bench, 600, modes, "a cut, 10 s later", survived);
  step_by_any_length(bench, modes, survived);
  cut_to(bench, 30, modes, "a cut, back in time", survived);
  take_turns(bench, modes, survived);
  return survived;
}

namespace {

double ghost_in(const FloatImage& resolved, const FloatImage& aliased) {
  double sum = 0;
  for (size_t i = 0; i < resolved.values.size(); ++i)
    sum += std::abs(double(resolved.values[i]) - double(aliased.values[i]));
  return sum;
}

} // namespace

/// A history of thousands of frames beside one of a hundred, on the same frames.
std::vector<Survival> survive_thousands(StabilityBench& bench, std::span<const ModeRun> modes) {
  const uint32_t frames = bench.endurance == Endurance::brief   ? 300
                          : bench.endurance == Endurance::usual ? 5000
                                                                : 100'000;
  constexpr uint32_t judged = 100, filled = 100;
  std::vector<ModeRun> runs(modes.begin(), modes.end());
  for (ModeRun& run : runs) run.taa.policy.jitter = Jitter::none; // compared with the aliased frame
  std::vector<ModeRun> both = runs;
  both.insert(both.end(), runs.begin(), runs.end()); // the same once more, from where the young ones begin
  both.push_back({.name = "off", .taa = {}});
  std::vector<double> old_ghost(modes.size()), young_ghost(modes.size());
  for (uint32_t frame = 0; frame < frames; ++frame) {
    const bool young = frame + judged + filled >= frames, counts = frame + judged >= frames;
    FrameInput input = at(frame, young ? std::span<const ModeRun>(both) : std::span<const ModeRun>(runs));
    if (!counts) input.wanted = {{Output::resolved, 0}};
    const Values values = drawn(bench, input);
    for (size_t mode = 0; counts && mode < modes.size(); ++mode) {
      old_ghost[mode] += ghost_in(values[mode], values.back());
      young_ghost[mode] += ghost_in(values[modes.size() + mode], values.back());
    }
  }
  std::vector<Survival> survived(modes.size());
  for (size_t mode = 0; mode < modes.size(); ++mode)
    worsen(survived[mode],
           young_ghost[mode] > 0 ? std::abs(old_ghost[mode] / young_ghost[mode] - 1) : old_ghost[mode],
           "after " + std::to_string(frames) + " frames");
  return survived;
}

} // namespace unghost
