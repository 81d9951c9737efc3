#include "app/measure/flicker.h"

#include <algorithm>
#include <cmath>

namespace unghost {
namespace {

bool seen_in_both(const PixelHistory& pixel) {
  return pixel.steady_frames > 0 || pixel.change == Change::shadow;
}

/// The edge goes on.
float bilinear(const FloatImage& image, float x, float y, uint32_t channel) {
  const auto at = [&](int column, int row) {
    const auto c = size_t(std::clamp(column, 0, int(image.width) - 1)),
               r = size_t(std::clamp(row, 0, int(image.height) - 1));
    return image.values[(r * image.width + c) * image.channels + channel];
  };
  const float left = std::floor(x), top = std::floor(y), fx = x - left, fy = y - top;
  const int column = int(left), row = int(top);
  const float above = at(column, row) * (1 - fx) + at(column + 1, row) * fx,
              below = at(column, row + 1) * (1 - fx) + at(column + 1, row + 1) * fx;
  return above * (1 - fy) + below * fy;
}

} // namespace

FloatImage excess(const Image& resolved, const Image& reference) {
  FloatImage image{.width = resolved.width, .height = resolved.height, .channels = 3, .values = {}};
  const size_t pixels = size_t(resolved.width) * resolved.height;
  image.values.reserve(pixels * 3);
  for (size_t pixel = 0; pixel < pixels; ++pixel)
    for (size_t channel = 0; channel < 3; ++channel)
      image.values.push_back(
          float(int(resolved.rgba[pixel * 4 + channel]) - int(reference.rgba[pixel * 4 + channel])) / 255);
  return image;
}

std::optional<double> flicker_between(const FloatImage& before, const FloatImage& now,
                                      const FloatImage& motion, std::span<const PixelHistory> pixels) {
  double sum = 0, count = 0;
  for (size_t pixel = 0; pixel < pixels.size(); ++pixel) {
    if (!seen_in_both(pixels[pixel])) continue;
    const float x = float(pixel % now.width) + motion.values[pixel * 2],
                y = float(pixel / now.width) + motion.values[pixel * 2 + 1];
    for (uint32_t channel = 0; channel < 3; ++channel)
      sum += std::abs(double(now.values[pixel * 3 + channel]) - double(bilinear(before, x, y, channel)));
    count += 3;
  }
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

} // namespace unghost
