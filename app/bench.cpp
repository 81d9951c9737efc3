// `unghost bench`: what each mode adds to a frame, from GPU timestamps. The modes take turns within each
// round, beside their naive resolves and a full-screen copy, so that a slow minute slows all of them.
#include <algorithm>
#include <numeric>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/headless.h"
#include "app/measure/protocols.h"
#include "app/measure/quantile.h"
#include "app/measure/run_time.h"
#include "app/progress.h"
#include "app/table.h"

namespace unghost {
namespace {

/// Nothing where nothing was to be compared.
nlohmann::json median_of(const std::vector<double>& ratios) {
  return ratios.empty() ? nlohmann::json() : nlohmann::json(quantile(ratios, 0.5));
}

nlohmann::json json_of(const std::string& mode, const ModeTimes& row) {
  return {{"mode", mode},
          {"ms", quantile(row.added_ms, 0.5)},
          {"p05", quantile(row.added_ms, 0.05)},
          {"p95", quantile(row.added_ms, 0.95)},
          {"resolve_ms", quantile(row.resolve_ms, 0.5)},
          {"over_copy", median_of(row.over_copy)},
          {"over_naive", median_of(row.over_naive)},
          {"over_no_rejection", median_of(row.over_no_rejection)},
          {"over_plain_store", median_of(row.over_plain_store)}};
}

void add_rows(const Shot& shot, const RunTimes& times, nlohmann::json& object) {
  for (size_t mode = 0; mode < shot.modes.size(); ++mode)
    object["rows"].push_back(json_of(shot.modes[mode].name, times.modes[mode]));
}

/// Frames of their own, beside the rows.
void add_sharing(const Shot& shot, Headless& headless, nlohmann::json& object) {
  constexpr uint32_t rounds = 5;
  const Sharing sharing = time_sharing(headless.film(), shot.modes, rounds);
  object["together_ms"] = sharing.together_ms;
  object["alone_ms"] = std::reduce(sharing.alone_ms.begin(), sharing.alone_ms.end());
  for (size_t mode = 0; mode < shot.modes.size(); ++mode)
    object["rows"][mode]["alone_ms"] = sharing.alone_ms[mode];
}

struct Column {
  const char *figure, *head;
  int decimals;
};
constexpr Column columns[] = {{"ms", "adds ms", 2},
                              {"p05", "5%", 2},
                              {"p95", "95%", 2},
                              {"resolve_ms", "resolve ms", 2},
                              {"over_copy", "over copy", 2},
                              {"over_naive", "over naive", 3},
                              {"over_no_rejection", "over no rejection", 3},
                              {"over_plain_store", "over plain store", 3},
                              {"alone_ms", "frame alone ms", 1}};

Table table_of(const nlohmann::json& rows) {
  const auto asked = [&](const Column& column) { return rows.front().contains(column.figure); };
  std::vector<std::string> heads{"mode"};
  for (const Column& column : columns)
    if (asked(column)) heads.push_back(column.head);
  Table table(std::move(heads));
  for (const nlohmann::json& row : rows) {
    std::vector<std::string> cells{row.at("mode").get<std::string>()};
    for (const Column& column : columns) {
      if (!asked(column)) continue;
      const nlohmann::json& figure = row.at(column.figure);
      cells.push_back(figure.is_null() ? "-" : fixed(figure.get<double>(), column.decimals));
    }
    table.add(std::move(cells));
  }
  return table;
}

} // namespace

void bench(const CommandLine& line, Console& console) {
  const Shot shot = shot_from(line);
  for (const ModeRun& run : shot.modes)
    if (run.taa.resolver != Resolver::fast || run.taa.store != Store::dithered)
      throw SettingError("bench times both resolvers and stores; resolver and store are not for it");
  const uint32_t rounds = line.rounds.value_or(protocols().front().rounds);
  Headless headless(line, shot, console);
  RunTimes times;
  {
    Progress progress(console, timed_work(shot.modes, rounds, true));
    progress.name(shot.rig);
    const Film film = headless.film([&](double work) { progress.step(work); });
    times = time_modes(film, shot.modes, rounds, true);
  }
  nlohmann::json object = headless.facts();
  object["size"] = text_of(shot.size), object["rounds"] = rounds, object["rig"] = shot.rig;
  object["scene"] = shot.scene, object["seed"] = shot.seed;
  object["copy_ms"] = quantile(times.copy_ms, 0.5), object["motion_ms"] = quantile(times.motion_ms, 0.5);
  object["geometry_ms"] = quantile(times.geometry_ms, 0.5);
  add_rows(shot, times, object);
  if (line.alone) add_sharing(shot, headless, object);
  console.out << (line.json ? object.dump(2) + "\n" : table_of(object["rows"]).text());
  if (!line.json && !console.quiet)
    console.err << "what a mode adds is its resolve, its sharpening and the motion pass ("
                << fixed(object["motion_ms"].get<double>(), 2) << " ms); a full-screen copy took "
                << fixed(object["copy_ms"].get<double>(), 2) << " ms; medians of the ratios and times of "
                << rounds << (rounds == 1 ? " round\n" : " rounds\n");
  if (line.alone && !line.json && !console.quiet)
    console.err << "one frame of all " << shot.modes.size() << " modes took "
                << fixed(object["together_ms"].get<double>(), 0) << " ms, a frame of each alone "
                << fixed(object["alone_ms"].get<double>(), 0) << " ms in sum\n";
  headless.finish();
}

} // namespace unghost
