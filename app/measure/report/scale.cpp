#include <algorithm>
#include <cmath>

#include "app/measure/report/chart.h"
#include "app/measure/report/html.h"

namespace unghost {
namespace {

constexpr double room_for_zero = 0.09, room_beyond_knee = 0.26; // of the axis

/// As few decimals as tell `value` from its neighbours, `step` away.
std::string tick_text(double value, double step) {
  const int decimals = std::clamp(int(std::ceil(-std::log10(step) - 1e-9)), 0, 9);
  return number(value, decimals);
}

/// 1, 2 or 5 times a power of ten, such that a span has `count` of them or fewer.
double step_for(double span, int count) {
  const double least = span / count, power = std::pow(10, std::floor(std::log10(least)));
  for (const double times : {1., 2., 5.})
    if (power * times >= least * (1 - 1e-9)) return power * times;
  return power * 10;
}

} // namespace

Scale::Scale(const ChartAxis& axis, const std::vector<double>& values) {
  if (!axis.rows.empty()) {
    make_rows(axis.rows);
    return;
  }
  double low = INFINITY, high = -INFINITY, least = INFINITY;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value), high = std::max(high, value);
    if (value > 0) least = std::min(least, value);
  }
  if (!(low <= high)) low = 0, high = 1;
  if (axis.log && std::isfinite(least))
    make_log(least, high, low <= 0, axis.knee > least && axis.knee < high ? axis.knee : 0);
  else
    make_linear(low, high);
}

void Scale::make_rows(const std::vector<std::string>& rows) {
  rows_ = true, high_ = double(rows.size());
  for (size_t i = 0; i < rows.size(); ++i) ticks_.push_back({(*this)(double(i)), rows[i]});
}

void Scale::make_linear(double low, double high) {
  if (low > 0 && low < 0.4 * high) low = 0;
  if (high - low <= 1e-9 * std::max(std::abs(low), std::abs(high)))
    low -= std::abs(low) / 2, high += high == 0 ? 1 : std::abs(high) / 2;
  const double step = step_for(high - low, 6);
  low_ = std::floor(low / step + 0.02) * step, high_ = std::ceil(high / step - 0.02) * step;
  if (low < low_) low_ -= step;
  if (high > high_) high_ += step;
  std::vector<double> values;
  const auto steps = int(std::lround((high_ - low_) / step));
  for (int i = 0; i <= steps; ++i) values.push_back(low_ + i * step);
  low_ -= 0.025 * (high_ - low_); // so that nothing lies on the frame
  for (const double at : values)
    ticks_.push_back({(*this)(at), tick_text(std::abs(at) < step / 1e6 ? 0 : at, step)});
}

void Scale::make_log(double low, double high, bool with_zero, double knee) {
  log_ = true, zero_ends_ = with_zero ? room_for_zero : 0;
  const double air =
      std::max(0.05 * std::log10((knee > 0 ? knee : high) / low), 0.06); // nothing on the frame
  low_ = std::log10(low) - air, high_ = knee_ = std::log10(high) + air;
  if (with_zero) breaks_.push_back(0.7 * zero_ends_);
  if (knee > 0) {
    knee_ = std::log10(knee) + air, knee_at_ = 1 - room_beyond_knee;
    breaks_.push_back(knee_at_);
  }
  if (with_zero) ticks_.push_back({(*this)(0), "0"});
  add_log_ticks(low_, knee_);
  if (const size_t zeros = with_zero ? 1 : 0; ticks_.size() < zeros + 2) {
    ticks_.resize(zeros); // the one that is there would be written over: 5 and 5.0
    add_linear_ticks();
  }
  if (knee > 0) add_log_ticks(knee_ + 0.12 * (high_ - knee_), high_);
}

/// 1, 2, 5 of each decade; where there are many decades only their beginnings, within one more.
void Scale::add_log_ticks(double from, double to) {
  const double decades = to - from, room = (*this)(std::pow(10, to)) - (*this)(std::pow(10, from));
  const std::vector<double> parts = decades > 3.2 * room   ? std::vector<double>{1}
                                    : decades > 1.1 * room ? std::vector<double>{1, 2, 5}
                                    : decades > 0.4 * room
                                        ? std::vector<double>{1, 1.5, 2, 3, 4, 5, 7}
                                        : std::vector<double>{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9};
  for (double decade = std::floor(from); decade <= to; ++decade)
    for (const double times : parts) {
      const double value = std::pow(10, decade) * times;
      if (std::log10(value) >= from && std::log10(value) <= to)
        ticks_.push_back({(*this)(value),
                          tick_text(value, std::pow(10, decade) * (times == std::floor(times) ? 1 : 0.1))});
    }
}

/// Of a range too narrow for the others.
void Scale::add_linear_ticks() {
  const double from = std::pow(10, low_), to = std::pow(10, knee_), step = step_for(to - from, 5);
  for (double value = std::ceil(from / step) * step; value < to; value += step)
    ticks_.push_back({(*this)(value), tick_text(value, step)});
  std::ranges::sort(ticks_, {}, &Tick::at);
  const auto twice = std::ranges::unique(ticks_, {}, &Tick::text);
  ticks_.erase(twice.begin(), twice.end());
}

double Scale::operator()(double value) const {
  if (rows_) return 1 - (value + 0.5) / high_;
  if (!log_) return (value - low_) / (high_ - low_);
  if (value <= 0) return zero_ends_ / 3;
  const double exponent = std::log10(value);
  if (knee_ < high_ && exponent > knee_)
    return knee_at_ + (1 - knee_at_) * (exponent - knee_) / (high_ - knee_);
  return zero_ends_ + (knee_at_ - zero_ends_) * (exponent - low_) / (knee_ - low_);
}

Scales scales_of(const Chart& chart) {
  std::vector<double> x, y;
  for (const ChartSeries& series : chart.series)
    for (const ChartPoint& point : series.points) x.push_back(point.x), y.push_back(point.y);
  return {Scale(chart.x, x), Scale(chart.y, y)};
}

} // namespace unghost
