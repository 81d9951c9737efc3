#include <algorithm>
#include <cmath>

#include "app/measure/report/chart.h"
#include "app/measure/report/html.h"
#include "app/measure/report/labels.h"

namespace unghost {
namespace {

constexpr double top = 10, axis_room = 46;

std::string attribute(const char* name, double value) {
  return std::string(" ") + name + "=\"" + number(value, 1) + "\"";
}

/// Of one chart, in pixels.
struct Sheet {
  const Chart& chart;
  Scales scales;
  bool lines;
  double width, left, right, bottom;

  explicit Sheet(const Chart& of)
      : chart(of), scales(scales_of(of)),
        lines(std::ranges::any_of(of.series, [](const ChartSeries& s) { return s.mark == Mark::line; })),
        width(of.wide ? 1168 : 568), left(58), right(width - 14), bottom(of.wide ? 420 : 370) {
    if (lines) right -= 96; // for their names
    if (of.y.rows.empty()) return;
    left = 104, bottom = top + 22 * double(of.y.rows.size());
  }
  double x(double value) const { return left + (right - left) * scales.x(value); }
  double y(double value) const { return bottom - (bottom - top) * scales.y(value); }
};

std::string line_between(double x1, double y1, double x2, double y2, const char* kind) {
  return std::string("<line class=\"") + kind + "\"" + attribute("x1", x1) + attribute("y1", y1) +
         attribute("x2", x2) + attribute("y2", y2) + "/>";
}

std::string words(double x, double y, const char* kind, const std::string& text) {
  return std::string("<text class=\"") + kind + "\"" + attribute("x", x) + attribute("y", y) + ">" +
         escaped(text) + "</text>";
}

std::string axes_of(const Sheet& sheet) {
  std::string svg = "<g class=\"axes\" aria-hidden=\"true\">";
  for (const Tick& tick : sheet.scales.x.ticks()) {
    const double x = sheet.left + (sheet.right - sheet.left) * tick.at;
    svg += line_between(x, top, x, sheet.bottom, "grid") + words(x, sheet.bottom + 16, "tick-x", tick.text);
  }
  for (const Tick& tick : sheet.scales.y.ticks()) {
    const double y = sheet.bottom - (sheet.bottom - top) * tick.at;
    svg += line_between(sheet.left, y, sheet.right, y, "grid") +
           words(sheet.left - 7, y + 4, "tick-y", tick.text);
  }
  svg += line_between(sheet.left, sheet.bottom, sheet.right, sheet.bottom, "axis");
  for (const double at : sheet.scales.x.breaks())
    svg += words(sheet.left + (sheet.right - sheet.left) * at, sheet.bottom + 4, "break", "//");
  svg += words((sheet.left + sheet.right) / 2, sheet.bottom + 36, "label-x", sheet.chart.x.label);
  if (sheet.chart.y.rows.empty()) {
    const std::string middle = number((top + sheet.bottom) / 2, 1);
    svg += "<text class=\"label-x\" transform=\"translate(13 " + middle + ") rotate(-90)\">" +
           escaped(sheet.chart.y.label) + "</text>";
  }
  return svg + "</g>";
}

std::string polyline(const Sheet& sheet, const ChartSeries& series, const char* kind) {
  std::string points;
  for (const ChartPoint& p : series.points)
    points += (points.empty() ? "" : " ") + number(sheet.x(p.x), 1) + "," + number(sheet.y(p.y), 1);
  return std::string("<polyline class=\"") + kind + "\" points=\"" + points + "\"/>";
}

std::string shapes(const Sheet& sheet, const ChartSeries& series, double radius) {
  std::string svg;
  for (const ChartPoint& p : series.points)
    svg += "<g class=\"" + std::string(p.on_front ? "point on-front" : "point") + "\">" +
           (p.note.empty() ? "" : "<title>" + escaped(p.note) + "</title>") +
           svg_shape(series.look.shape, sheet.x(p.x), sheet.y(p.y), radius) + "</g>";
  return svg;
}

std::string marks_of(const Sheet& sheet, const ChartSeries& series) {
  switch (series.mark) {
  case Mark::point:
    return shapes(sheet, series, 5);
  case Mark::line:
    return polyline(sheet, series, "line") + shapes(sheet, series, 3.2);
  case Mark::reference:
    return polyline(sheet, series, "reference") + shapes(sheet, series, 2.6);
  case Mark::front:
    return polyline(sheet, series, "front");
  case Mark::whisker:
    return polyline(sheet, series, "whisker");
  case Mark::box:
    return polyline(sheet, series, "box");
  case Mark::strip: // one alone is no crowd
    return "<g class=\"strip\">" + shapes(sheet, series, series.points.size() == 1 ? 3 : 1.8) + "</g>";
  }
  return {};
}

bool has_names(const ChartSeries& series) {
  return !series.points.empty() &&
         (series.mark == Mark::point || series.mark == Mark::line || series.mark == Mark::reference);
}

struct Named {
  Label label;
  const ChartSeries* series;
  bool on_front;
};

/// What points and lines are called; the front's first, so that they get the best places.
std::vector<Named> names_of(const Sheet& sheet) {
  std::vector<Named> names;
  if (!sheet.chart.y.rows.empty()) return names;
  for (const ChartSeries& series : sheet.chart.series) {
    if (!has_names(series)) continue;
    const auto add = [&](const std::string& name, const ChartPoint& at) {
      names.push_back({{name, sheet.x(at.x), sheet.y(at.y), at.on_front}, &series, at.on_front});
    };
    for (const ChartPoint& point : series.points)
      if (!point.name.empty()) add(point.name, point);
    if (series.points.back().name.empty()) add(series.name, series.points.back());
  }
  std::ranges::stable_sort(names, {}, [](const Named& n) { return std::pair(!n.on_front, n.label.y); });
  return names;
}

/// Where marks and lines are.
std::vector<Area> marked(const Sheet& sheet) {
  std::vector<Area> areas;
  const auto add = [&](double x, double y, double radius) {
    areas.push_back({x - radius, y - radius, x + radius, y + radius});
  };
  for (const ChartSeries& series : sheet.chart.series) {
    if (series.mark == Mark::point)
      for (const ChartPoint& p : series.points) add(sheet.x(p.x), sheet.y(p.y), 6);
    if (series.mark != Mark::reference && series.mark != Mark::front) continue;
    for (size_t i = 1; i < series.points.size(); ++i) {
      const double x = sheet.x(series.points[i - 1].x), y = sheet.y(series.points[i - 1].y);
      const double across = sheet.x(series.points[i].x) - x, down = sheet.y(series.points[i].y) - y;
      const double steps = std::ceil(std::hypot(across, down) / 4);
      for (double step = 0; step < steps; ++step) add(x + across * step / steps, y + down * step / steps, 2);
    }
  }
  return areas;
}

std::string labels_of(const Sheet& sheet) {
  const std::vector<Named> names = names_of(sheet);
  std::vector<Label> labels;
  for (const Named& name : names) labels.push_back(name.label);
  const auto placed =
      sheet.lines ? place_at_ends(labels)
                  : place_labels(labels, marked(sheet), {sheet.left + 2, top, sheet.width, sheet.bottom - 2});
  std::string svg = "<g class=\"labels\" aria-hidden=\"true\">";
  for (size_t i = 0; i < names.size(); ++i) {
    const PlacedLabel& at = placed[i];
    const double middle = at.y - label_size * 0.28, end = at.x + text_width(labels[i]);
    svg += "<g data-mode=\"" + escaped(names[i].series->mode) + "\">";
    if (at.far)
      svg += line_between(labels[i].x, labels[i].y, std::clamp(labels[i].x, at.x - 2, end), middle, "leader");
    const char* kind = names[i].series->mark == Mark::reference ? "name beside"
                       : names[i].on_front                      ? "name best"
                                                                : "name";
    svg += words(at.x, at.y, kind, labels[i].text) + "</g>";
  }
  return svg + "</g>";
}

} // namespace

std::string svg_of(const Chart& chart) {
  const Sheet sheet(chart);
  std::string svg = "<svg class=\"chart\" role=\"img\" aria-label=\"" + escaped(chart.title) +
                    "\" viewBox=\"0 0 " + number(sheet.width, 0) + " " + number(sheet.bottom + axis_room, 0) +
                    "\">" + axes_of(sheet);
  for (const ChartSeries& series : chart.series)
    svg += "<g class=\"series " + (series.mode.empty() ? "plain" : "f" + std::to_string(series.look.family)) +
           "\" data-mode=\"" + escaped(series.mode) + "\">" + marks_of(sheet, series) + "</g>";
  return svg + labels_of(sheet) + "</svg>";
}

std::string figure_of(const Chart& chart) {
  return "<figure class=\"plot" + std::string(chart.wide ? " across" : "") + "\" id=\"" + chart.id +
         "\"><figcaption><strong>" + escaped(chart.title) + "</strong> " + escaped(chart.caption) +
         "</figcaption><div class=\"sheet\">" + svg_of(chart) + "</div></figure>\n";
}

} // namespace unghost
