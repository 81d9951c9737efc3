#include "app/measure/smoothing.h"

#include <algorithm>
#include <cmath>

namespace unghost {
namespace {

// One direction: `count` samples `stride` floats apart, with `channels` floats a sample.
void smooth_line(const float* from, float* to, int count, size_t stride, uint32_t channels,
                 std::span<const float> weights) {
  const int radius = int(weights.size() / 2);
  for (int i = 0; i < count; ++i)
    for (uint32_t c = 0; c < channels; ++c) {
      float sum = 0;
      for (int k = -radius; k <= radius; ++k)
        sum += weights[size_t(k + radius)] * from[size_t(std::clamp(i + k, 0, count - 1)) * stride + c];
      to[size_t(i) * stride + c] = sum;
    }
}

} // namespace

FloatImage smoothed(const FloatImage& image, std::span<const float> weights) {
  FloatImage across = image, both = image;
  const size_t row = size_t(image.width) * image.channels;
  for (uint32_t y = 0; y < image.height; ++y)
    smooth_line(&image.values[y * row], &across.values[y * row], int(image.width), image.channels,
                image.channels, weights);
  for (uint32_t x = 0; x < image.width; ++x)
    smooth_line(&across.values[size_t(x) * image.channels], &both.values[size_t(x) * image.channels],
                int(image.height), row, image.channels, weights);
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
