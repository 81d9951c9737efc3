// A chart as a value: drawn as SVG, and as data for the script that makes it interactive. Both take positions
// from the same scales.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/measure/report/look.h"

namespace unghost {

enum class Mark {
  point,     // shapes, each with its name
  line,      // shapes joined, named at the end
  reference, // dashed, of no mode: what is to be beaten
  front,     // stairs along the best points
  whisker,   // thin
  box,       // thick
  strip      // small dots
};

struct ChartPoint {
  double x = 0, y = 0;
  std::string note; // what hovering says
  bool on_front = false;
  std::string name; // beside it; the last point of a series without names bears the series' own
};
struct ChartSeries {
  std::string name;
  Mark mark = Mark::point;
  Look look;
  std::string mode; // that a filter hides it with; empty: always there
  std::vector<ChartPoint> points;
};
struct ChartAxis {
  std::string label; // with its unit
  bool log = false;
  std::vector<std::string> rows; // names in place of numbers: 0 is the first
  double knee = 0;               // of a logarithmic axis: what lies beyond is pressed into its end. 0: none
};
struct Chart {
  std::string id, title, caption;
  bool wide = false; // as the page, not as half of it
  ChartAxis x, y;
  std::vector<ChartSeries> series;
};

struct Tick {
  double at = 0;
  std::string text;
};
/// From values to 0 (left, bottom) to 1.
class Scale {
public:
  Scale(const ChartAxis& axis, const std::vector<double>& values);
  double operator()(double value) const;
  const std::vector<Tick>& ticks() const { return ticks_; }
  /// Where the scale begins anew: after 0, which has a place of its own before a logarithmic one, and at the
  /// knee.
  const std::vector<double>& breaks() const { return breaks_; }

private:
  void make_rows(const std::vector<std::string>& rows);
  void make_linear(double low, double high);
  void make_log(double low, double high, bool with_zero, double knee);
  void add_log_ticks(double from, double to);
  void add_linear_ticks();

  bool log_ = false, rows_ = false;
  double low_ = 0, high_ = 1;                     // logarithms where log_
  double zero_ends_ = 0, knee_ = 0, knee_at_ = 1; // of log_: positions, but for the knee's own logarithm
  std::vector<double> breaks_;
  std::vector<Tick> ticks_;
};
struct Scales {
  Scale x, y;
};
Scales scales_of(const Chart& chart);

/// An <svg> element; text and shapes follow the page's colours.
std::string svg_of(const Chart& chart);
/// Positions from 0 to 1, ticks with their texts.
nlohmann::json chart_json(const Chart& chart);
/// A <figure> with the caption and the SVG.
std::string figure_of(const Chart& chart);

} // namespace unghost
