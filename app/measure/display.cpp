#include "app/measure/display.h"

#include <algorithm>
#include <cmath>

namespace unghost {
namespace {

// Narkowicz 2015, "ACES filmic tone mapping curve".
float tone_mapped(float x) {
  return std::clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.f, 1.f);
}

float srgb_from_linear(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

} // namespace

FloatImage displayed(const FloatImage& linear, float exposure_ev) {
  const float exposure = std::exp2(exposure_ev);
  FloatImage image{.width = linear.width, .height = linear.height, .channels = 3, .values = {}};
  image.values.resize(size_t(linear.width) * linear.height * 3);
  for (size_t pixel = 0; pixel < size_t(linear.width) * linear.height; ++pixel)
    for (uint32_t c = 0; c < 3; ++c)
      image.values[pixel * 3 + c] = srgb_from_linear(
          tone_mapped(std::max(0.0f, linear.values[pixel * linear.channels + c] * exposure)));
  return image;
}

} // namespace unghost
