#include <algorithm>
#include <cmath>
#include <optional>

#include "app/measure/report/case_charts.h"
#include "app/measure/report/html.h"
#include "app/measure/report/pareto.h"

namespace unghost {
namespace {

constexpr std::string_view shown[] = {"error", "ghosting", "shimmer", "flicker", "trail"};
/// These are of motion.
constexpr std::string_view none_at_rest[] = {"ghosting", "trail"};
/// A frame without jitter and history has none of these by definition: they are taken against it, or between
/// frames of it that are the same.
constexpr std::string_view none_when_aliased[] = {"ghosting", "trail", "shimmer"};

bool is_among(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

std::optional<double> figure_in(const std::map<std::string, double>& figures, std::string_view name) {
  const auto found = figures.find(std::string(name));
  if (found == figures.end() || !std::isfinite(found->second)) return {};
  return found->second;
}

/// What is shown as 0 is 0, or the first digits of nothing would stretch a logarithmic scale.
std::optional<CostAndError> point_of(const std::map<std::string, double>& figures, const FigureKind& kind) {
  const auto cost = figure_in(figures, "added_ms"), error = figure_in(figures, kind.name);
  if (!cost || !error) return {};
  return CostAndError{std::max(0., *cost), as_read(*error, kind.decimals) == 0 ? 0 : *error};
}

/// The notch of a median: two that do not overlap differ at about 95%. 1.57 times the middle half of the
/// rounds over the root of their number (McGill, Tukey and Larsen 1978); of a normal distribution the middle
/// half is .41 of what lies between p05 and p95. No less than half of the third digit, the last that is
/// shown.
double margin_of(const Measured& m, const std::map<std::string, double>& figures, double cost) {
  const double digit = cost > 0 ? 0.5 * std::pow(10, std::floor(std::log10(cost)) - 2) : 0;
  const auto low = figure_in(figures, "p05"), high = figure_in(figures, "p95");
  if (!low || !high || !m.timing || m.timing->rounds == 0) return digit;
  return std::max(digit, 1.57 * 0.41 * (*high - *low) / std::sqrt(double(m.timing->rounds)));
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

/// Along the points of the front, never upwards: an error that is a little higher reads alike.
ChartSeries stairs(const Measured& m, const std::vector<size_t>& front, const FigureKind& kind) {
  ChartSeries line{.name = "Pareto front", .mark = Mark::front, .look = {}, .mode = {}, .points = {}};
  for (const size_t i : front) {
    const CostAndError at = *point_of(m.rows[i].figures, kind);
    if (!line.points.empty()) line.points.push_back({at.cost, line.points.back().y});
    line.points.push_back(
        {at.cost, line.points.empty() ? at.error : std::min(at.error, line.points.back().y)});
  }
  return line;
}

/// Of two samples and more: one is the aliased frame, which is a mode.
ChartSeries supersampling(const Measured& m, const FigureKind& kind) {
  ChartSeries line{.name = "supersampling", .mark = Mark::reference, .look = {}, .mode = {}, .points = {}};
  for (Supersampled one : m.supersampled) {
    if (m.timing) one.figures["added_ms"] = (one.samples - 1) * m.timing->geometry_ms;
    const auto at = point_of(one.figures, kind);
    if (!at || one.samples < 2) continue;
    const std::string name = std::to_string(one.samples);
    line.points.push_back({at->cost, at->error, note_of(name + " samples", *at, kind), false, name});
  }
  std::ranges::sort(line.points, {}, &ChartPoint::x);
  if (!line.points.empty()) line.points.back().name += " samples";
  return line;
}

/// Supersampling costs far more than the modes, and would press them together.
double knee_of(const ChartSeries& supersampled, double cheapest_mode, double dearest_mode) {
  const bool far = !supersampled.points.empty() && supersampled.points.back().x > 4 * dearest_mode;
  return far && cheapest_mode < dearest_mode ? dearest_mode : 0;
}

std::string caption_of(const FigureKind& kind, bool supersampled, bool bent) {
  std::string text = std::string(kind.summary) + " Less is better on both axes.";
  if (supersampled)
    text += std::string(" Dashed: the mean of so many samples a pixel") +
            (bent ? ", beyond the last // on a tighter scale." : ".");
  if (is_among(kind.name, none_when_aliased))
    text += " The aliased frame itself, at 0 ms, has none of it and is on no front here.";
  return text;
}

Chart chart_of(const Measured& m, const Looks& looks, const FigureKind& kind, const std::string& id) {
  Chart chart{
      .id = id + "-" + std::string(kind.name),
      .title = capital(kind.label) + " against time",
      .caption = {},
      .x = {.label = "time added, ms (log)", .log = true, .rows = {}},
      .y = {.label = std::string(kind.label) + ", " + std::string(kind.unit), .log = false, .rows = {}},
      .series = {}};
  const std::vector<size_t> front = front_of(m, kind);
  double least = INFINITY, most = 0, cheapest = INFINITY, dearest = 0;
  const ChartSeries supersampled = supersampling(m, kind);
  for (const ChartSeries& line : {supersampled, stairs(m, front, kind)})
    if (!line.points.empty()) chart.series.push_back(line);
  for (size_t i = 0; i < m.rows.size(); ++i)
    if (const auto at = point_of(m.rows[i].figures, kind)) {
      const std::string& mode = m.rows[i].mode;
      const bool on_front = std::ranges::find(front, i) != front.end();
      chart.series.push_back({.name = mode,
                              .mark = Mark::point,
                              .look = looks.at(mode),
                              .mode = mode,
                              .points = {{at->cost, at->error, note_of(mode, *at, kind), on_front}}});
      if (at->error > 0) least = std::min(least, at->error), most = std::max(most, at->error);
      dearest = std::max(dearest, at->cost);
      if (at->cost > 0) cheapest = std::min(cheapest, at->cost);
    }
  chart.x.knee = knee_of(supersampled, cheapest, dearest);
  chart.caption = caption_of(kind, !supersampled.points.empty(), chart.x.knee > 0);
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
    return (is_at_rest(m) && is_among(kind->name, none_at_rest)) ||
           std::ranges::none_of(m.rows, [&](const MeasuredMode& row) {
             return row.figures.contains(std::string(kind->name));
           });
  });
  return kinds;
}

bool is_candidate(const Measured& m, const MeasuredMode& row, const FigureKind& kind) {
  if (is_at_rest(m) && is_among(kind.name, none_at_rest)) return false;
  const auto at = point_of(row.figures, kind);
  return at && (at->cost > 0 || !is_among(kind.name, none_when_aliased));
}

std::vector<size_t> front_of(const Measured& m, const FigureKind& kind) {
  std::vector<CostAndError> points;
  for (const MeasuredMode& row : m.rows) {
    CostAndError point{NAN, NAN};
    if (is_candidate(m, row, kind)) {
      point = *point_of(row.figures, kind);
      point.error = as_read(point.error, kind.decimals),
      point.cost_margin = margin_of(m, row.figures, point.cost);
    }
    points.push_back(point);
  }
  return pareto_front(points);
}

std::vector<Chart> work_precision(const Measured& m, const Looks& looks, const std::string& id) {
  std::vector<Chart> charts;
  for (const FigureKind* kind : errors_in(m))
    if (std::ranges::any_of(m.rows,
                            [&](const MeasuredMode& r) { return point_of(r.figures, *kind).has_value(); }))
      charts.push_back(chart_of(m, looks, *kind, id));
  if (!charts.empty()) charts.front().wide = true;
  return charts;
}

} // namespace unghost
