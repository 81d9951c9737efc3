#include "app/measure/smoothing.h"

#include <algorithm>
#include <cmath>

namespace unghost {
namespace {

// `count` floats of which each is a sum of those around it, `stride` apart, between ends that were extended.
void smooth_along(const float* __restrict from, float* __restrict to, size_t count, size_t stride,
                  std::span<const float> weights) {
  for (size_t i = 0; i < count; ++i) to[i] = weights[0] * from[i];
  for (size_t k = 1; k < weights.size(); ++k)
    for (size_t i = 0; i < count; ++i) to[i] += weights[k] * from[i + k * stride];
}

} // namespace

FloatImage smoothed(const FloatImage& image, std::span<const float> weights) {
  const size_t row = size_t(image.width) * image.channels, radius = weights.size() / 2;
  const size_t pad = radius * image.channels;
  FloatImage across = image, both = image;
  std::vector<float> extended(row + 2 * pad);
  for (size_t y = 0; y < image.height; ++y) {
    const float* from = &image.values[y * row];
    std::copy_n(from, row, &extended[pad]);
    for (size_t i = 0; i < pad; ++i) {
      extended[i] = from[i % image.channels];
      extended[pad + row + i] = from[row - image.channels + i % image.channels];
    }
    smooth_along(extended.data(), &across.values[y * row], row, image.channels, weights);
  }
  for (size_t y = 0; y < image.height; ++y) {
    float* to = &both.values[y * row];
    std::fill_n(to, row, 0.0f);
    for (size_t k = 0; k < weights.size(); ++k) {
      const size_t at = std::clamp<size_t>(y + k, radius, image.height - 1 + radius) - radius;
      const float* from = &across.values[at * row];
      for (size_t i = 0; i < row; ++i) to[i] += weights[k] * from[i];
    }
  }
  return both;
}

FloatImage gaussian_3x3(const FloatImage& image) {
  constexpr float weights[] = {0.25f, 0.5f, 0.25f};
  return smoothed(image, weights);
}

FloatImage gaussian_5x5(const FloatImage& image) {
  constexpr double sigma = 1.5;
  const double near = std::exp(-0.5 / (sigma * sigma)), far = std::exp(-2 / (sigma * sigma));
  const double sum = 1 + 2 * near + 2 * far;
  const float weights[] = {float(far / sum), float(near / sum), float(1 / sum), float(near / sum),
                           float(far / sum)};
  return smoothed(image, weights);
}

} // namespace unghost
