#include "app/measure/run_time.h"

#include <algorithm>
#include <map>
#include <string>

#include "app/measure/quantile.h"

namespace unghost {
namespace {

constexpr uint32_t warm_up_frames = 4;    // shaders are compiled at first use, histories fill
constexpr uint32_t rounds_of_others = 61; // beside the modes as they are: enough for a median

/// Milliseconds of one pass, a round each.
using Times = std::map<std::string, std::vector<double>>;

const std::string resolve = "taa ", sharpening = "sharpen ", naively = " naively",
                  no_rejection = " without rejection", plain_store = " as the device stores";

bool tests_history(const ModeRun& run) {
  return (uint32_t(run.taa.policy.reject) & ~uint32_t(Reject::off_screen)) != 0;
}

bool adds_anything(const ModeRun& run) { return run.taa.policy.needs_history() || run.taa.sharpen > 0; }

/// Those that add anything, as they are; `off`, which adds nothing, where there is no other.
std::vector<ModeRun> as_they_are(const std::vector<ModeRun>& modes) {
  std::vector<ModeRun> runs;
  std::ranges::copy_if(modes, std::back_inserter(runs), adds_anything);
  if (runs.empty()) runs.push_back(modes.front());
  return runs;
}

/// Behind them, so that they keep their places and their histories when these are no longer drawn: each by
/// the naive resolve and, where it has tests, without them; and for `stores` without its dithering.
std::vector<ModeRun> with_others(std::vector<ModeRun> runs, bool stores) {
  for (size_t mode = 0, count = runs.size(); mode < count; ++mode) {
    if (!runs[mode].taa.policy.needs_history()) continue;
    ModeRun naive = runs[mode];
    naive.name += naively, naive.taa.resolver = Resolver::naive;
    ModeRun plain = runs[mode];
    plain.name += no_rejection, plain.taa.policy.reject = Reject::off_screen;
    ModeRun cut = runs[mode];
    cut.name += plain_store, cut.taa.store = Store::plain;
    if (stores) runs.push_back(std::move(cut));
    runs.push_back(std::move(naive));
    if (tests_history(runs[mode])) runs.push_back(std::move(plain));
  }
  return runs;
}

/// Round by round, as long as both are there.
std::vector<double> ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    if (b[i] > 0) ratios.push_back(a[i] / b[i]);
  return ratios;
}

std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> sums = a;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) sums[i] += b[i];
  return sums;
}

ModeTimes times_of(const ModeRun& run, Times& times) {
  ModeTimes mode;
  if (!adds_anything(run)) return mode;
  mode.added_ms = times[sharpening + run.name];
  if (run.taa.policy.needs_history()) {
    mode.resolve_ms = times[resolve + run.name];
    mode.over_copy = ratio(mode.resolve_ms, times["copy"]);
    mode.over_naive = ratio(mode.resolve_ms, times[resolve + run.name + naively]);
    mode.over_plain_store = ratio(mode.resolve_ms, times[resolve + run.name + plain_store]);
    mode.over_no_rejection = ratio(mode.resolve_ms, times[resolve + run.name + no_rejection]);
    mode.added_ms = sum(sum(mode.resolve_ms, times["motion"]), mode.added_ms);
  }
  mode.added_over_copy = ratio(mode.added_ms, times["copy"]);
  return mode;
}

void note(const FrameResult& result, Times& times) {
  double geometry = 0;
  for (const PassReport& pass : result.passes) {
    times[pass.name].push_back(pass.ms);
    if (pass.name == "g-buffer" || pass.name == "light")
      geometry += pass.ms; // shadows are drawn once a frame
  }
  times["geometry"].push_back(geometry);
}

} // namespace

Sharing time_sharing(const Film& film, const std::vector<ModeRun>& modes, uint32_t rounds) {
  const auto frame_ms = [&](const std::vector<ModeRun>& drawn) {
    double ms = 0;
    for (const uint32_t frame : {0u, 1u}) {
      FrameInput input = film.at(frame);
      input.modes = drawn;
      for (size_t mode = 0; mode < drawn.size(); ++mode) input.wanted.push_back({Output::resolved, mode});
      const FrameResult result = film.draw(input);
      ms = 0;
      for (const PassReport& pass : result.passes) ms += pass.ms;
    }
    return ms;
  };
  std::vector<double> together;
  std::vector<std::vector<double>> alone(modes.size());
  for (uint32_t round = 0; round <= rounds; ++round) { // the first one warms up
    for (size_t mode = 0; mode < modes.size(); ++mode) {
      const double ms = frame_ms({modes[mode]});
      if (round > 0) alone[mode].push_back(ms);
    }
    const double all = frame_ms(modes);
    if (round > 0) together.push_back(all);
  }
  Sharing sharing{.together_ms = quantile(together, 0.5), .alone_ms = {}};
  for (const std::vector<double>& times : alone) sharing.alone_ms.push_back(quantile(times, 0.5));
  return sharing;
}

double timed_work(const std::vector<ModeRun>& modes, uint32_t rounds, bool stores) {
  FrameInput few, all;
  few.modes = as_they_are(modes), all.modes = with_others(few.modes, stores);
  const uint32_t with = warm_up_frames + std::min(rounds, rounds_of_others);
  return with * work_of(all) + (warm_up_frames + rounds - with) * work_of(few);
}

RunTimes time_modes(const Film& film, const std::vector<ModeRun>& modes, uint32_t rounds, bool stores) {
  const std::vector<ModeRun> few = as_they_are(modes), all = with_others(few, stores);
  Times times;
  for (uint32_t frame = 0; frame < warm_up_frames + rounds; ++frame) {
    FrameInput input = film.at(frame);
    input.modes = frame < warm_up_frames + rounds_of_others ? all : few;
    input.timed = true;
    const FrameResult result = film.draw(input);
    if (frame >= warm_up_frames) note(result, times);
  }
  RunTimes run{
      .modes = {}, .copy_ms = times["copy"], .motion_ms = times["motion"], .geometry_ms = times["geometry"]};
  for (const ModeRun& mode : modes) run.modes.push_back(times_of(mode, times));
  return run;
}

} // namespace unghost
