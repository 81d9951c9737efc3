#include "app/measure/trail.h"

#include <algorithm>
#include <cmath>

#include "app/measure/display.h"
#include "app/measure/smoothing.h"

namespace unghost {
namespace {

bool counts(const PixelHistory& pixel) {
  return pixel.steady_frames < trail_frames &&
         (pixel.change == Change::surface || pixel.change == Change::shadow);
}

struct Vec {
  double r, g, b;
};

Vec difference(const FloatImage& a, const FloatImage& b, size_t pixel) {
  const float *x = &a.values[pixel * 3], *y = &b.values[pixel * 3];
  return {double(x[0]) - y[0], double(x[1]) - y[1], double(x[2]) - y[2]};
}

double dot(const Vec& a, const Vec& b) { return a.r * b.r + a.g * b.g + a.b * b.b; }

} // namespace

void TrailMeter::add(std::span<const PixelHistory> pixels, const TrailImages& images) {
  const auto seen = [this](const FloatImage& linear) {
    return gaussian_5x5(displayed(linear, exposure_ev_));
  };
  const FloatImage aliased = seen(images.aliased), accumulated = seen(images.accumulated);
  const FloatImage blurred = seen(gaussian_3x3(images.aliased));
  for (size_t mode = 0; mode < modes_.size(); ++mode) {
    const FloatImage resolved = seen(*images.resolved[mode]);
    Sums& frame = modes_[mode].frames.emplace_back();
    for (size_t pixel = 0; pixel < pixels.size(); ++pixel) {
      if (!counts(pixels[pixel])) continue;
      const Vec ghost = difference(accumulated, aliased, pixel);
      const double kept = std::max(0.0, dot(difference(resolved, aliased, pixel), ghost));
      const double blur = std::max(0.0, dot(difference(blurred, aliased, pixel), ghost));
      const bool surface = pixels[pixel].change == Change::surface;
      for (Sums* sums : {surface ? &modes_[mode].surface : &modes_[mode].shadow, &frame}) {
        sums->remaining += std::max(0.0, kept - blur);
        sums->all += dot(ghost, ghost);
      }
    }
  }
}

Trail TrailMeter::trail_of(size_t mode) const {
  const auto share = [](double remaining, double all) {
    return all > 0 ? std::optional(remaining / all) : std::nullopt;
  };
  const auto& [surface, shadow, frames] = modes_.at(mode);
  return {.whole = share(surface.remaining + shadow.remaining, surface.all + shadow.all),
          .surface = share(surface.remaining, surface.all),
          .shadow = share(shadow.remaining, shadow.all)};
}

} // namespace unghost
