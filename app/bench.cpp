// `unghost bench`: what each mode adds to a frame, from GPU timestamps. The modes take turns within each
// round, beside their naive resolves and a full-screen copy, so that a slow minute slows all of them.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/headless.h"
#include "app/measure/quantile.h"
#include "app/table.h"

namespace unghost {
namespace {

constexpr uint32_t warm_up_frames = 4; // shaders are compiled at first use, histories fill

/// Milliseconds of one pass, a round each.
using Times = std::map<std::string, std::vector<double>>;

const std::string naively = " naively", no_rejection = " without rejection";

bool tests_history(const ModeRun& run) {
  return (uint32_t(run.taa.policy.reject) & ~uint32_t(Reject::off_screen)) != 0;
}

/// Each mode that resolves anything as it is, by the naive resolve and, where it has tests, without them.
std::vector<ModeRun> runs_of(const Shot& shot) {
  std::vector<ModeRun> runs;
  for (const ModeRun& run : shot.modes) {
    if (!run.taa.policy.needs_history()) continue;
    runs.push_back(run);
    ModeRun& naive = runs.emplace_back(run);
    naive.name += naively, naive.taa.resolver = Resolver::naive;
    if (!tests_history(run)) continue;
    ModeRun& plain = runs.emplace_back(run);
    plain.name += no_rejection, plain.taa.policy.reject = Reject::off_screen;
  }
  if (runs.empty()) runs.push_back(shot.modes.front()); // `off`, which adds nothing, is drawn all the same
  return runs;
}

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

Times time_passes(const Shot& shot, Headless& headless) {
  Times times;
  const auto take = [&](uint32_t frame, const auto&, const FrameResult& result) {
    if (frame < warm_up_frames) return;
    for (const PassReport& pass : result.passes) times[pass.name].push_back(pass.ms);
  };
  headless.render_timed(runs_of(shot), take);
  return times;
}

struct Row {
  std::string mode;
  std::vector<double> added, resolve; // ms a round: all passes that `off` has not; those of the resolve alone
  std::vector<double> over_copy, over_naive, over_no_rejection; // of the resolve
};

Row row_of(const ModeRun& run, Times& times) {
  Row row{.mode = run.name,
          .added = {},
          .resolve = {},
          .over_copy = {},
          .over_naive = {},
          .over_no_rejection = {}};
  if (!run.taa.policy.needs_history()) return row;
  row.resolve = times["taa " + run.name];
  row.over_copy = ratio(row.resolve, times["copy"]);
  row.over_naive = ratio(row.resolve, times["taa " + run.name + naively]);
  row.over_no_rejection = ratio(row.resolve, times["taa " + run.name + no_rejection]);
  row.added = sum(sum(row.resolve, times["motion"]), times["sharpen " + run.name]);
  return row;
}

/// Nothing where nothing was to be compared.
nlohmann::json median_of(const std::vector<double>& ratios) {
  return ratios.empty() ? nlohmann::json() : nlohmann::json(quantile(ratios, 0.5));
}

nlohmann::json json_of(const Row& row) {
  return {{"mode", row.mode},
          {"ms", quantile(row.added, 0.5)},
          {"p05", quantile(row.added, 0.05)},
          {"p95", quantile(row.added, 0.95)},
          {"resolve_ms", quantile(row.resolve, 0.5)},
          {"over_copy", median_of(row.over_copy)},
          {"over_naive", median_of(row.over_naive)},
          {"over_no_rejection", median_of(row.over_no_rejection)}};
}

} // namespace

void bench(const CommandLine& line, Console& console) {
  Shot shot = shot_from(line);
  for (const ModeRun& run : shot.modes)
    if (run.taa.resolver != Resolver::fast)
      throw SettingError("bench times both resolvers; resolver is not for it");
  const uint32_t rounds = shot.frames;
  shot.frames += warm_up_frames;
  Headless headless(line, shot, console);
  Times times = time_passes(shot, headless);
  nlohmann::json object = headless.facts();
  object["size"] = text_of(shot.size), object["rounds"] = rounds, object["rig"] = shot.rig;
  object["scene"] = shot.scene, object["seed"] = shot.seed;
  object["copy_ms"] = quantile(times["copy"], 0.5), object["motion_ms"] = quantile(times["motion"], 0.5);
  Table table{{"mode", "adds ms", "5%", "95%", "resolve ms", "over copy", "over naive", "over no rejection"}};
  for (const ModeRun& run : shot.modes) {
    const nlohmann::json row = object["rows"].emplace_back(json_of(row_of(run, times)));
    const auto cell = [&](const char* name, int digits) {
      return row.at(name).is_null() ? "-" : fixed(row.at(name).get<double>(), digits);
    };
    table.add({run.name, cell("ms", 2), cell("p05", 2), cell("p95", 2), cell("resolve_ms", 2),
               cell("over_copy", 2), cell("over_naive", 3), cell("over_no_rejection", 3)});
  }
  console.out << (line.json ? object.dump(2) + "\n" : table.text());
  if (!line.json && !console.quiet)
    console.err << "what a mode adds is its resolve, its sharpening and the motion pass ("
                << fixed(object["motion_ms"].get<double>(), 2) << " ms); a full-screen copy took "
                << fixed(object["copy_ms"].get<double>(), 2) << " ms; medians of the ratios and times of "
                << rounds << " rounds\n";
  headless.finish();
}

} // namespace unghost
