#include "app/measure/flip.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>
#include <numeric>
#include <thread>

#include "app/measure/flip_kernel.h"
#include "app/measure/quantile.h"

namespace unghost {
namespace {

/// Bands of rows, a thread each; the last one here. What one throws comes out after all have ended.
template <class Work> void in_bands(size_t rows, unsigned threads, const Work& work) {
  const size_t bands = std::clamp<size_t>(rows / 16, 1, threads_of(threads));
  std::vector<std::exception_ptr> faults(bands);
  const auto one = [&](size_t band) {
    try {
      work(rows * band / bands, rows * (band + 1) / bands);
    } catch (...) {
      faults[band] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    others.reserve(bands - 1);
    for (size_t band = 0; band + 1 < bands; ++band) others.emplace_back([&one, band] { one(band); });
    one(bands - 1);
  }
  for (const std::exception_ptr& fault : faults)
    if (fault) std::rethrow_exception(fault);
}

/// `row_of(y, buffer)` gives one row of linear RGB; it may lie in the buffer.
template <class RowOf>
SeenPicture seen_by_rows(uint32_t width, uint32_t height, const FlipOptions& options, const RowOf& row_of) {
  const FlipFilters filters(options.pixels_per_degree);
  SeenPicture out{.width = width, .height = height, .l = {}, .a = {}, .b = {}, .edge = {}, .point = {}};
  for (auto* plane : {&out.l, &out.a, &out.b, &out.edge, &out.point}) plane->resize(size_t(width) * height);
  constexpr size_t slice = 64; // rows at a time: their planes stay in the cache
  in_bands(height, options.threads, [&](size_t first, size_t last) {
    OpponentPlanes planes(width, std::min<size_t>(height, slice + 2 * filters.reach));
    std::vector<float> buffer(size_t(width) * 3);
    for (size_t y = first; y < last; y += slice) {
      const size_t end = std::min(y + slice, last);
      planes.top = y - std::min(y, filters.reach);
      planes.height = std::min<size_t>(end + filters.reach, height) - planes.top;
      for (size_t row = 0; row < planes.height; ++row)
        opponent_row(row_of(planes.top + row, buffer.data()), row, planes);
      see_rows(planes, filters, y, end, out);
    }
  });
  return out;
}

std::array<float, 256> linear_of_bytes() {
  std::array<float, 256> linear;
  for (size_t i = 0; i < 256; ++i) {
    const double c = double(i) / 255;
    linear[i] = float(c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return linear;
}

/// (k0 x^2 + k1 x + k2) / (k3 x^2 + k4 x + k5); the flip program's.
std::array<double, 6> curve_of(ToneMapper mapper) {
  switch (mapper) {
  case ToneMapper::hable:
    return {0.231683, 0.013791, 0, 0.18, 0.3, 0.018};
  case ToneMapper::reinhard:
    return {0, 1, 0, 0, 1, 1};
  case ToneMapper::aces:
    break;
  }
  return {0.36 * 2.51, 0.6 * 0.03, 0, 0.36 * 2.43, 0.6 * 0.59, 0.14};
}

/// What the curve maps to 0.85: the larger one.
double brightest(ToneMapper mapper) {
  const auto k = curve_of(mapper);
  const double t = 0.85, a = k[0] - t * k[3], b = k[1] - t * k[4], c = k[2] - t * k[5];
  if (a == 0) return -c / b;
  const double root = std::sqrt(b * b - 4 * a * c);
  return std::max((-b + root) / (2 * a), (-b - root) / (2 * a));
}

float luminance(const float* c) { return 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2]; }

/// `count` pixels as they look `stops` brighter.
void tone_map(const float* linear, size_t count, double stops, ToneMapper mapper, float* out) {
  const auto kd = curve_of(mapper);
  std::array<float, 6> k;
  std::ranges::copy(kd, k.begin());
  const auto scale = float(std::exp2(stops));
  for (size_t i = 0; i < 3 * count; ++i) out[i] = linear[i] * scale;
  if (mapper == ToneMapper::reinhard) {
    for (size_t i = 0; i < count; ++i) {
      float* c = out + 3 * i;
      const float whole = 1 / (1 + luminance(c));
      for (int channel = 0; channel < 3; ++channel) c[channel] *= whole;
    }
  } else {
    for (size_t i = 0; i < 3 * count; ++i) {
      const float x = out[i];
      out[i] = ((k[0] * x + k[1]) * x + k[2]) / ((k[3] * x + k[4]) * x + k[5]);
    }
  }
}

SeenPicture seen_exposed(const FloatImage& linear, double stops, ToneMapper mapper,
                         const FlipOptions& options) {
  return seen_by_rows(linear.width, linear.height, options, [&](size_t y, float* rgb) {
    tone_map(&linear.values[3 * y * linear.width], linear.width, stops, mapper, rgb);
    return rgb;
  });
}

} // namespace

double pixels_per_degree(double distance_m, double monitor_px, double monitor_m) {
  return distance_m * (monitor_px / monitor_m) * std::numbers::pi / 180;
}

unsigned threads_of(unsigned threads) {
  return threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency());
}

FloatImage linear_from_srgb(const Image& picture) {
  const std::array<float, 256> linear = linear_of_bytes();
  FloatImage out{.width = picture.width, .height = picture.height, .channels = 3, .values = {}};
  out.values.reserve(size_t(picture.width) * picture.height * 3);
  for (size_t i = 0; i < size_t(picture.width) * picture.height; ++i)
    for (size_t channel = 0; channel < 3; ++channel)
      out.values.push_back(linear[picture.rgba[4 * i + channel]]);
  return out;
}

SeenPicture seen(const FloatImage& linear, const FlipOptions& options) {
  return seen_by_rows(linear.width, linear.height, options,
                      [&](size_t y, float*) { return &linear.values[y * linear.width * 3]; });
}

SeenPicture seen(const Image& srgb, const FlipOptions& options) {
  const std::array<float, 256> linear = linear_of_bytes();
  return seen_by_rows(srgb.width, srgb.height, options, [&](size_t y, float* rgb) {
    const uint8_t* bytes = &srgb.rgba[y * srgb.width * 4];
    for (size_t x = 0; x < srgb.width; ++x)
      for (size_t channel = 0; channel < 3; ++channel) rgb[3 * x + channel] = linear[bytes[4 * x + channel]];
    return rgb;
  });
}

FloatImage flip(const SeenPicture& reference, const SeenPicture& test, const FlipOptions& options) {
  FloatImage error{.width = reference.width, .height = reference.height, .channels = 1, .values = {}};
  error.values.resize(reference.l.size());
  in_bands(reference.height, options.threads, [&](size_t first, size_t last) {
    const size_t begin = first * reference.width;
    compare_pixels(reference, test, begin, last * reference.width - begin, &error.values[begin]);
  });
  return error;
}

double mean_flip(const SeenPicture& reference, const SeenPicture& test, const FlipOptions& options) {
  const size_t width = reference.width;
  std::vector<double> rows(reference.height); // summed alone, so that bands change nothing
  in_bands(reference.height, options.threads, [&](size_t first, size_t last) {
    std::vector<float> errors(width);
    for (size_t y = first; y < last; ++y) {
      compare_pixels(reference, test, y * width, width, errors.data());
      rows[y] = std::accumulate(errors.begin(), errors.end(), 0.0);
    }
  });
  return std::accumulate(rows.begin(), rows.end(), 0.0) / double(reference.l.size());
}

FloatImage flip(const FloatImage& reference, const FloatImage& test, const FlipOptions& options) {
  return flip(seen(reference, options), seen(test, options), options);
}

uint32_t exposures_between(double first, double last) {
  return uint32_t(std::max(2.0, std::ceil(last - first)));
}

Exposures exposures_of(const FloatImage& reference, ToneMapper mapper) {
  std::vector<float> all;
  for (size_t i = 0; i < reference.values.size(); i += 3) all.push_back(luminance(&reference.values[i]));
  const float most = *std::ranges::max_element(all);
  if (!(most > 0)) return {};
  float median = quantile(all, 0.5);
  if (!(median > 0)) {
    std::erase_if(all, [](float value) { return !(value > 0); });
    median = quantile(all, 0.5);
  }
  const double white = brightest(mapper), first = std::log2(white / most), last = std::log2(white / median);
  return {.first = first, .last = last, .count = exposures_between(first, last)};
}

HdrFlip hdr_flip(const FloatImage& reference, const FloatImage& test, const Exposures& exposures,
                 ToneMapper mapper, const FlipOptions& options) {
  HdrFlip worst{.error = {reference.width, reference.height, 1, {}},
                .exposure = {reference.width, reference.height, 1, {}}};
  worst.error.values.resize(size_t(reference.width) * reference.height);
  worst.exposure.values.resize(worst.error.values.size());
  for (uint32_t i = 0; i < exposures.count; ++i) {
    const double share = exposures.count > 1 ? double(i) / (exposures.count - 1) : 0;
    const double stops = exposures.first + share * (exposures.last - exposures.first);
    const FloatImage error = flip(seen_exposed(reference, stops, mapper, options),
                                  seen_exposed(test, stops, mapper, options), options);
    for (size_t pixel = 0; pixel < error.values.size(); ++pixel)
      if (error.values[pixel] > worst.error.values[pixel])
        worst.error.values[pixel] = error.values[pixel], worst.exposure.values[pixel] = float(share);
  }
  return worst;
}

FlipSummary summary_of(std::span<const float> errors) {
  std::vector<float> sorted(errors.begin(), errors.end());
  std::ranges::sort(sorted);
  double total = 0;
  for (const float error : sorted) total += error;
  double below = 0;
  size_t at = 0;
  const auto weighted_quantile = [&](double share) { // ask for rising shares
    while (at + 1 < sorted.size() && below + sorted[at] < share * total) below += sorted[at++];
    return double(sorted[at]);
  };
  FlipSummary s{.mean = total / double(sorted.size()), .min = sorted.front(), .max = sorted.back()};
  s.weighted_first_quartile = weighted_quantile(0.25);
  s.weighted_median = weighted_quantile(0.5);
  s.weighted_third_quartile = weighted_quantile(0.75);
  return s;
}

} // namespace unghost
