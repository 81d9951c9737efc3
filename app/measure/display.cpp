#include "app/measure/display.h"

#include <bit>
#include <cmath>

#include "shaders/shared/tonemap.h"

namespace unghost {
namespace {

/// The display's curve. What is read back from a device are 16-bit floats, of which there are few: what it
/// makes of each is computed once.
class Curve {
public:
  explicit Curve(float exposure) : exposure_(exposure) {
    known_.reserve(exponents << fraction_bits);
    for (uint32_t i = 0; i < exponents << fraction_bits; ++i)
      known_.push_back(computed(std::bit_cast<float>((first + i) << dropped_bits)));
  }
  float operator()(float linear) const {
    const auto bits = std::bit_cast<uint32_t>(linear);
    const uint32_t at = (bits >> dropped_bits) - first; // wraps for what lies before the first
    return (bits & ((1u << dropped_bits) - 1)) == 0 && at < known_.size() ? known_[at] : computed(linear);
  }

private:
  // positive numbers that are not denormal in 16 bits, as 32 bits have them
  static constexpr uint32_t fraction_bits = 10, dropped_bits = 13, exponents = 30,
                            first = 113u << fraction_bits;

  float computed(float linear) const { return display_from_linear(glm::vec3(linear * exposure_)).x; }

  float exposure_;
  std::vector<float> known_;
};

} // namespace

FloatImage displayed(const FloatImage& linear, float exposure_ev) {
  const Curve curve(std::exp2(exposure_ev));
  FloatImage image{.width = linear.width, .height = linear.height, .channels = 3, .values = {}};
  const size_t pixels = size_t(linear.width) * linear.height;
  image.values.reserve(pixels * 3);
  for (size_t pixel = 0; pixel < pixels; ++pixel)
    for (size_t channel = 0; channel < 3; ++channel)
      image.values.push_back(curve(linear.values[pixel * linear.channels + channel]));
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
