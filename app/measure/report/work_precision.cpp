#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/measure/report/case_charts.h"
#include "app/measure/report/html.h"
#include "app/measure/report/pareto.h"

namespace unghost {
namespace {

constexpr std::string_view shown[] = {"error", "ghosting", "shimmer", "flicker", "trail"};
/// A frame without jitter and history has none of these by definition: they are taken against it, or between
/// frames of it that are the same.
constexpr std::string_view none_when_aliased[] = {"ghosting", "trail", "shimmer"};

std::optional<double> figure_in(const std::map<std::string, double>& figures, std::string_view name) {
  const auto found = figures.find(std::string(name));
  if (found == figures.end() || !std::isfinite(found->second)) return {};
  return found->second;
}

std::optional<CostAndError> point_of(const std::map<std::string, double>& figures, std::string_view figure) {
  const auto cost = figure_in(figures, "added_ms"), error = figure_in(figures, figure);
  if (!cost || !error) return {};
  return CostAndError{std::max(0., *cost), *error};
}

std::string capital(std::string_view word) {
  std::string text(word);
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text;
}

std::string note_of(const std::string& name, const CostAndError& at, const FigureKind& kind) {
  return name + ": " + std::string(kind.label) + " " + number(at.error, kind.decimals) + ", adds " +
         milliseconds(at.cost) + " ms";
}

/// Along the points: nothing known reaches below.
ChartSeries stairs(const Measured& m, const std::vector<size_t>& front, const FigureKind& kind) {
  ChartSeries line{.name = "Pareto front", .mark = Mark::front, .look = {}, .mode = {}, .points = {}};
  for (const size_t i : front) {
    const CostAndError at = *point_of(m.rows[i].figures, kind.name);
    if (!line.points.empty()) line.points.push_back({at.cost, line.points.back().y});
    line.points.push_back({at.cost, at.error});
  }
  return line;
}

ChartSeries supersampling(const Measured& m, const FigureKind& kind) {
  ChartSeries line{.name = "supersampling", .mark = Mark::reference, .look = {}, .mode = {}, .points = {}};
  for (Supersampled one : m.supersampled) {
    if (m.timing) one.figures["added_ms"] = (one.samples - 1) * m.timing->geometry_ms;
    if (const auto at = point_of(one.figures, kind.name)) {
      const std::string name = std::to_string(one.samples) + (one.samples == 1 ? " sample" : " samples");
      // one sample is the aliased frame, which has its own name there
      line.points.push_back(
          {at->cost, at->error, note_of(name, *at, kind), false, one.samples > 1 ? name : ""});
    }
  }
  std::ranges::sort(line.points, {}, &ChartPoint::x);
  return line;
}

std::string caption_of(const FigureKind& kind) {
  std::string text = std::string(kind.summary) + " Less is better on both axes.";
  if (std::ranges::find(none_when_aliased, kind.name) != std::end(none_when_aliased))
    text += " The aliased frame itself, at 0 ms, has none of it and is on no front here.";
  return text;
}

Chart chart_of(const Measured& m, const Looks& looks, const FigureKind& kind, const std::string& id) {
  Chart chart{
      .id = id + "-" + std::string(kind.name),
      .title = capital(kind.label) + " against time",
      .caption = caption_of(kind),
      .x = {.label = "time added, ms (log)", .log = true, .rows = {}},
      .y = {.label = std::string(kind.label) + ", " + std::string(kind.unit), .log = false, .rows = {}},
      .series = {}};
  const std::vector<size_t> front = front_of(m, kind.name);
  double least = INFINITY, most = 0;
  for (const ChartSeries& line : std::array{supersampling(m, kind), stairs(m, front, kind)})
    if (!line.points.empty()) chart.series.push_back(line);
  for (size_t i = 0; i < m.rows.size(); ++i)
    if (const auto at = point_of(m.rows[i].figures, kind.name)) {
      const std::string& mode = m.rows[i].mode;
      const bool on_front = std::ranges::find(front, i) != front.end();
      chart.series.push_back({.name = mode,
                              .mark = Mark::point,
                              .look = looks.at(mode),
                              .mode = mode,
                              .points = {{at->cost, at->error, note_of(mode, *at, kind), on_front}}});
      if (at->error > 0) least = std::min(least, at->error), most = std::max(most, at->error);
    }
  if (most > 6 * least) // one of them would press the others together
    chart.y.log = true, chart.y.label += " (log)";
  return chart;
}

} // namespace

std::vector<const FigureKind*> judged_by() {
  std::vector<const FigureKind*> kinds;
  for (const std::string_view name : shown)
    kinds.push_back(&*std::ranges::find(figure_kinds(), name, &FigureKind::name));
  return kinds;
}

std::vector<const FigureKind*> errors_in(const Measured& m) {
  std::vector<const FigureKind*> kinds = judged_by();
  std::erase_if(kinds, [&](const FigureKind* kind) {
    return std::ranges::none_of(
        m.rows, [&](const MeasuredMode& row) { return row.figures.contains(std::string(kind->name)); });
  });
  return kinds;
}

std::vector<size_t> front_of(const Measured& m, std::string_view figure) {
  const bool leaves_out_aliased = std::ranges::find(none_when_aliased, figure) != std::end(none_when_aliased);
  std::vector<CostAndError> points;
  for (const MeasuredMode& row : m.rows) {
    const auto at = point_of(row.figures, figure);
    const bool counts = at && !(leaves_out_aliased && at->cost == 0);
    points.push_back(counts ? *at : CostAndError{NAN, NAN});
  }
  return pareto_front(points);
}

std::vector<Chart> work_precision(const Measured& m, const Looks& looks, const std::string& id) {
  std::vector<Chart> charts;
  for (const FigureKind* kind : errors_in(m))
    if (std::ranges::any_of(
            m.rows, [&](const MeasuredMode& r) { return point_of(r.figures, kind->name).has_value(); }))
      charts.push_back(chart_of(m, looks, *kind, id));
  if (!charts.empty()) charts.front().wide = true;
  return charts;
}

} // namespace unghost
