#include <cmath>

#include "app/measure/report/chart.h"

namespace unghost {
namespace {

using nlohmann::json;

/// Enough for a screen.
double rounded(double position) { return std::round(position * 1e4) / 1e4; }

const char* word_of(Mark mark) {
  switch (mark) {
  case Mark::point:
    return "point";
  case Mark::line:
    return "line";
  case Mark::reference:
    return "reference";
  case Mark::front:
    return "front";
  case Mark::whisker:
    return "whisker";
  case Mark::box:
    return "box";
  case Mark::strip:
    return "strip";
  }
  return "";
}

json json_of(const ChartAxis& axis, const Scale& scale) {
  json ticks = json::array();
  for (const Tick& tick : scale.ticks()) ticks.push_back({rounded(tick.at), tick.text});
  json breaks = json::array();
  for (const double at : scale.breaks()) breaks.push_back(rounded(at));
  return {{"label", axis.label}, {"ticks", ticks}, {"rows", axis.rows.size()}, {"breaks", breaks}};
}

} // namespace

json chart_json(const Chart& chart) {
  const Scales scales = scales_of(chart);
  json object = {{"title", chart.title},
                 {"wide", chart.wide},
                 {"x", json_of(chart.x, scales.x)},
                 {"y", json_of(chart.y, scales.y)},
                 {"series", json::array()}};
  for (const ChartSeries& series : chart.series) {
    json points = json::array();
    for (const ChartPoint& point : series.points)
      points.push_back(
          {rounded(scales.x(point.x)), rounded(scales.y(point.y)), point.note, point.on_front, point.name});
    object["series"].push_back({{"name", series.name},
                                {"mark", word_of(series.mark)},
                                {"family", series.mode.empty() ? -1 : series.look.family},
                                {"shape", series.look.shape},
                                {"mode", series.mode},
                                {"points", points}});
  }
  return object;
}

} // namespace unghost
