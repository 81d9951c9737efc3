// `unghost measure`: figures, all modes from the same frames.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/headless.h"
#include "app/measure/trail.h"
#include "app/table.h"

namespace unghost {
namespace {

constexpr uint32_t fill_frames = 16; // the quick protocol: as many are measured by default

void check_words(const CommandLine& line, const Shot& shot) {
  const std::vector<std::string> known = {"trail"};
  const std::vector<std::string> planned = {"ghosting", "shimmer", "error", "flicker", "time"};
  for (const std::string& what : line.what) {
    if (std::ranges::count(known, what) > 0) continue;
    if (std::ranges::count(planned, what) > 0)
      throw WrongWords("--what " + what + " is not there yet; trail is");
    throw WrongWords("--what has no '" + what + "'" + did_you_mean(what, known));
  }
  if (shot.frames <= fill_frames)
    throw WrongWords("--frames counts the " + std::to_string(fill_frames) +
                     " frames that fill the history, so measuring wants more than those");
}

// Aliased and accumulated first, then the modes; without jitter, as all of a measurement.
std::vector<ModeRun> runs_of(const Shot& shot) {
  ModeRun aliased{.name = "aliased", .taa = {}};
  ModeRun accumulated{.name = "accumulated", .taa = {}};
  accumulated.taa.policy = {
      .history = HistoryFilter::catmull_rom, .reject = Reject::off_screen, .blend = Blend::constant};
  std::vector<ModeRun> runs = {aliased, accumulated};
  runs.insert(runs.end(), shot.modes.begin(), shot.modes.end());
  return runs;
}

constexpr Output surface_outputs[] = {Output::depth, Output::previous_depth, Output::motion, Output::object,
                                      Output::sun_visibility};

Surfaces surfaces_of(const std::vector<Wanted>& wanted, FrameResult& result) {
  const auto take = [&](Output what) { return std::move(delivered(wanted, result, what).image); };
  return {.depth = take(Output::depth),
          .previous_depth = take(Output::previous_depth),
          .motion = take(Output::motion),
          .object = take(Output::object),
          .sun_visibility = take(Output::sun_visibility)};
}

std::vector<Trail> measure_trail(const Shot& shot, Headless& headless) {
  const std::vector<ModeRun> runs = runs_of(shot);
  TrailMeter meter(shot.modes.size(), shot.settings.light.exposure_ev);
  Steadiness steadiness;
  const auto wants = [&](uint32_t frame) {
    std::vector<Wanted> wanted;
    for (const Output what : surface_outputs) wanted.push_back({what});
    for (size_t mode = 0; mode < runs.size() && frame >= fill_frames; ++mode)
      wanted.push_back({Output::resolved, mode});
    return wanted;
  };
  headless.render(runs, wants, [&](uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result) {
    steadiness.advance(surfaces_of(wanted, result));
    if (frame < fill_frames) return;
    const auto resolved = [&](size_t run) -> const FloatImage& {
      return delivered(wanted, result, Output::resolved, run).image;
    };
    TrailImages images{.aliased = resolved(0), .accumulated = resolved(1), .resolved = {}};
    for (size_t mode = 0; mode < shot.modes.size(); ++mode) images.resolved.push_back(&resolved(2 + mode));
    meter.add(steadiness.pixels(), images);
  });
  std::vector<Trail> trails;
  for (size_t mode = 0; mode < shot.modes.size(); ++mode) trails.push_back(meter.trail_of(mode));
  return trails;
}

nlohmann::json figure(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}
std::string cell(const std::optional<double>& value) { return value ? fixed(*value, 3) : "none"; }

} // namespace

void measure(const CommandLine& line, Console& console) {
  const Shot shot = shot_from(line);
  check_words(line, shot);
  Headless headless(line, shot, console);
  const std::vector<Trail> trails = measure_trail(shot, headless);
  nlohmann::json object = headless.facts();
  object.update(shot_json(shot, shot.frames));
  object["fill"] = fill_frames;
  Table table{{"mode", "trail", "surface", "shadow"}};
  for (size_t mode = 0; mode < trails.size(); ++mode) {
    const Trail& trail = trails[mode];
    object["rows"].push_back({{"mode", shot.modes[mode].name},
                              {"trail", figure(trail.whole)},
                              {"trail_surface", figure(trail.surface)},
                              {"trail_shadow", figure(trail.shadow)}});
    table.add({shot.modes[mode].name, cell(trail.whole), cell(trail.surface), cell(trail.shadow)});
  }
  if (!console.quiet && std::ranges::none_of(trails, [](const Trail& t) { return t.whole.has_value(); }))
    console.err
        << "no surface and no shadow changed in the frames that were measured, so there is no trail\n";
  console.out << (line.json ? object.dump(2) + "\n" : table.text());
  headless.finish();
}

} // namespace unghost
