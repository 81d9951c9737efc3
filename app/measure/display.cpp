#include "app/measure/display.h"

#include <cmath>

#include "shaders/shared/tonemap.h"

namespace unghost {

FloatImage displayed(const FloatImage& linear, float exposure_ev) {
  const float exposure = std::exp2(exposure_ev);
  FloatImage image{.width = linear.width, .height = linear.height, .channels = 3, .values = {}};
  const size_t pixels = size_t(linear.width) * linear.height;
  image.values.reserve(pixels * 3);
  for (size_t pixel = 0; pixel < pixels; ++pixel) {
    const float* from = &linear.values[pixel * linear.channels];
    const glm::vec3 shown = display_from_linear(glm::vec3(from[0], from[1], from[2]) * exposure);
    image.values.insert(image.values.end(), {shown.x, shown.y, shown.z});
  }
  return image;
}

Image displayed_8_bit(const FloatImage& linear, float exposure_ev) {
  const FloatImage shown = displayed(linear, exposure_ev);
  Image image{.name = {}, .width = linear.width, .height = linear.height, .rgba = {}};
  image.rgba.reserve(size_t(linear.width) * linear.height * 4);
  for (size_t i = 0; i < shown.values.size(); i += 3) {
    for (size_t channel = 0; channel < 3; ++channel)
      image.rgba.push_back(uint8_t(std::lround(shown.values[i + channel] * 255)));
    image.rgba.push_back(255);
  }
  return image;
}

} // namespace unghost
