#include "app/measure/report/case_charts.h"

#include <algorithm>

#include "app/measure/quantile.h"
#include "app/measure/report/html.h"

namespace unghost {
namespace {

Chart convergence_chart(const Convergence& of, const Looks& looks, std::string_view kind) {
  Chart chart{.id = {},
              .title = {},
              .caption = {},
              .x = {.label = "frames (log)", .log = true, .rows = {}},
              .y = {.label = "error, mean FLIP (log)", .log = true, .rows = {}},
              .series = {}};
  int member = 0;
  for (const ConvergenceCurve& curve : of.curves) {
    const bool reference = curve.kind == "supersampling";
    if (curve.kind != kind && !reference) continue;
    ChartSeries line{.name = reference ? "supersampling" : curve.name,
                     .mark = reference ? Mark::reference : Mark::line,
                     .look = {},
                     .mode = {},
                     .points = {}};
    if (!reference) {
      const auto look = looks.find(curve.name);
      const bool mode = kind == "mode" && look != looks.end();
      line.look = mode ? look->second : Look{member % int(families().size()), member % shape_count};
      line.mode = mode ? curve.name : std::string(kind) + ":" + curve.name;
      ++member;
    }
    for (size_t i = 0; i < curve.error.size(); ++i)
      line.points.push_back({double(of.frames[i]), curve.error[i],
                             line.name + ": " + number(curve.error[i], 4) + " after " +
                                 std::to_string(of.frames[i]) + (reference ? " samples" : " frames")});
    chart.series.push_back(std::move(line));
  }
  if (member == 0) chart.series.clear();
  return chart;
}

ChartSeries row_series(Mark mark, const Look& look, const std::string& mode, std::vector<ChartPoint> points) {
  return {.name = mode, .mark = mark, .look = look, .mode = mode, .points = std::move(points)};
}

/// The range of the middle 90%, the box of the middle half, the median, and up to so many of the rounds.
constexpr size_t most_dots = 60;

void add_times(Chart& chart, const MeasuredMode& row, const std::vector<double>& times, const Look& look) {
  const double y = double(chart.y.rows.size());
  chart.y.rows.push_back(row.mode);
  const auto at = [&](double share) { return ChartPoint{quantile(times, share), y}; };
  std::vector<ChartPoint> dots;
  const size_t count = std::min(times.size(), most_dots);
  for (size_t i = 0; i < count; ++i)
    dots.push_back({quantile(times, count < 2 ? 0 : double(i) / double(count - 1)), y - 0.36});
  ChartPoint median = at(0.5);
  median.note = row.mode + ": median " + milliseconds(median.x) + " ms, 5% " + milliseconds(at(0.05).x) +
                ", 95% " + milliseconds(at(0.95).x) + ", of " + std::to_string(times.size()) + " rounds";
  chart.series.push_back(row_series(Mark::strip, {look.family, 0}, row.mode, dots));
  chart.series.push_back(row_series(Mark::whisker, look, row.mode, {at(0.05), at(0.95)}));
  chart.series.push_back(row_series(Mark::box, look, row.mode, {at(0.25), at(0.75)}));
  chart.series.push_back(row_series(Mark::point, look, row.mode, {median}));
}

/// What reads as nothing is nothing: it would stretch a logarithmic scale.
double share_shown(double share) { return as_read(share, 3) == 0 ? 0 : share; }

} // namespace

std::vector<Chart> convergence_charts(const Measured& m, const Looks& looks, const std::string& id) {
  std::vector<Chart> charts;
  if (!m.convergence) return charts;
  Chart modes = convergence_chart(*m.convergence, looks, "mode");
  modes.id = id + "-convergence-modes", modes.title = "Convergence of the modes";
  modes.caption =
      "What is left after so many frames of a scene at rest; dashed: the mean of as many samples.";
  Chart jitters = convergence_chart(*m.convergence, looks, "jitter");
  jitters.id = id + "-convergence-jitters", jitters.title = "Convergence of the jitter sequences";
  jitters.caption = "One mode, other places of the samples; dashed: the mean of as many samples.";
  for (Chart* chart : {&modes, &jitters})
    if (!chart->series.empty()) charts.push_back(std::move(*chart));
  return charts;
}

std::vector<Chart> time_charts(const Measured& m, const Looks& looks, const std::string& id) {
  Chart chart{.id = id + "-times",
              .title = "Run time",
              .caption = "What each mode adds to a frame. Dots: up to 60 rounds, fastest to slowest; thin "
                         "line: the middle 90%; thick: "
                         "the middle half; mark: the median.",
              .x = {.label = "time added, ms (log)", .log = true, .rows = {}},
              .y = {.label = {}, .log = false, .rows = {}},
              .series = {}};
  for (const MeasuredMode& row : m.rows)
    if (const auto times = row.samples.find("added_ms"); times != row.samples.end() && !times->second.empty())
      add_times(chart, row, times->second, looks.at(row.mode));
  if (chart.series.empty()) return {};
  return {chart};
}

std::vector<Chart> trail_charts(const Measured& m, const Looks& looks, const std::string& id) {
  Chart chart{.id = id + "-trails",
              .title = "Trail",
              .caption =
                  "The share of the ghost that each mode leaves; 1 is all of it. Mark: the whole; the line "
                  "leads from surfaces (dot) to shadows (the other end).",
              .x = {.label = "share of the ghost that remains (log)", .log = true, .rows = {}},
              .y = {.label = {}, .log = false, .rows = {}},
              .series = {}};
  for (const MeasuredMode& row : m.rows) {
    const auto whole = row.figures.find("trail");
    if (whole == row.figures.end()) continue;
    const double y = double(chart.y.rows.size());
    const Look look = looks.at(row.mode);
    chart.y.rows.push_back(row.mode);
    std::string note = row.mode + ": trail " + number(whole->second, 3);
    const auto surface = row.figures.find("trail_surface"), shadow = row.figures.find("trail_shadow");
    if (surface != row.figures.end() && shadow != row.figures.end()) {
      note += ", surfaces " + number(surface->second, 3) + ", shadows " + number(shadow->second, 3);
      chart.series.push_back(
          row_series(Mark::whisker, look, row.mode,
                     {{share_shown(surface->second), y}, {share_shown(shadow->second), y}}));
      chart.series.push_back(
          row_series(Mark::strip, {look.family, 0}, row.mode, {{share_shown(surface->second), y}}));
    }
    chart.series.push_back(row_series(Mark::point, look, row.mode, {{share_shown(whole->second), y, note}}));
  }
  if (chart.series.empty()) return {};
  return {chart};
}

} // namespace unghost
