#include "app/measure/steadiness.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unghost {
namespace {

constexpr float depth_tolerance = 0.01f; // of the depth
constexpr float visibility_tolerance = 0.05f;
constexpr float sky = 0;

float at(const FloatImage& image, int x, int y, uint32_t channel = 0) {
  return image.values[(size_t(y) * image.width + size_t(x)) * image.channels + channel];
}

struct Range {
  float low = INFINITY, high = -INFINITY;

  void add(float value) { low = std::min(low, value), high = std::max(high, value); }
};

/// Over the pixels [x0, x1] x [y0, y1] that lie inside the frame.
Range range_of(const FloatImage& image, int x0, int y0, int x1, int y1) {
  Range range;
  for (int y = std::max(y0, 0); y <= std::min(y1, int(image.height) - 1); ++y)
    for (int x = std::max(x0, 0); x <= std::min(x1, int(image.width) - 1); ++x) range.add(at(image, x, y));
  return range;
}

bool same_depth(const FloatImage& last, float expected, int x, int y) {
  const Range range = range_of(last, x - 1, y - 1, x + 1, y + 1);
  return expected >= range.low * (1 - depth_tolerance) && expected <= range.high * (1 + depth_tolerance);
}

// The 2x2 are those that a bilinear history mixes.
bool same_light(const FloatImage& last, float visibility, float x, float y) {
  const Range range =
      range_of(last, int(std::floor(x)), int(std::floor(y)), int(std::ceil(x)), int(std::ceil(y)));
  return visibility >= range.low - visibility_tolerance && visibility <= range.high + visibility_tolerance;
}

} // namespace

void Steadiness::advance(Surfaces now) {
  std::vector<PixelHistory> next_pixels(size_t(now.depth.width) * now.depth.height);
  if (pixels_.size() == next_pixels.size())
    for (int y = 0; y < int(now.depth.height); ++y)
      for (int x = 0; x < int(now.depth.width); ++x)
        next_pixels[size_t(y) * now.depth.width + size_t(x)] = next(now, x, y);
  pixels_ = std::move(next_pixels);
  last_ = std::move(now);
}

PixelHistory Steadiness::next(const Surfaces& now, int x, int y) const {
  const float last_x = float(x) + at(now.motion, x, y, 0), last_y = float(y) + at(now.motion, x, y, 1);
  const float near_x = std::round(last_x), near_y = std::round(last_y);
  const int width = int(now.depth.width), height = int(now.depth.height);
  const bool inside = near_x >= 0 && near_y >= 0 && near_x < float(width) && near_y < float(height);
  if (!inside) return {.change = Change::edge};
  const int column = int(near_x), row = int(near_y);
  const float object = at(now.object, x, y);
  if (at(last_.object, column, row) != object) return {.change = Change::surface};
  if (object != sky && !same_depth(last_.depth, at(now.previous_depth, x, y), column, row))
    return {.change = Change::surface};
  if (object != sky && !same_light(last_.sun_visibility, at(now.sun_visibility, x, y), last_x, last_y))
    return {.change = Change::shadow};
  const PixelHistory& before = pixels_[size_t(row) * size_t(width) + size_t(column)];
  return {.steady_frames = uint8_t(std::min(before.steady_frames + 1, 255)), .change = before.change};
}

} // namespace unghost
