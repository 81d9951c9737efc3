#include "app/measure/display.h"

#include <cmath>

#include <gtest/gtest.h>

#include "shaders/shared/tonemap.h"

namespace unghost {
namespace {

/// Whatever a frame can hold, and what it cannot: numbers of 16 bits, between them, and beyond.
std::vector<float> numbers() {
  std::vector<float> all = {0, -1, 1e-8f, 6e-5f, 6.1035156e-5f, 0.1f, 65504, 65536, 1e15f};
  for (float x = 3e-5f; x < 70000; x *= 1.37f) all.push_back(x);
  for (float x = 0.25f; x < 0.26f; x += 1.0f / 4096) all.push_back(x); // exact in 16 bits
  while (all.size() % 3 != 0) all.push_back(1);
  return all;
}

TEST(Display, IsTheCurveOfTheFrameBitForBit) {
  const std::vector<float> all = numbers();
  for (const float exposure_ev : {0.0f, 1.5f, -3.0f}) {
    const FloatImage shown = displayed({uint32_t(all.size() / 3), 1, 3, all}, exposure_ev);
    for (size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(shown.values[i], display_from_linear(glm::vec3(all[i] * std::exp2(exposure_ev))).x) << all[i];
  }
}

TEST(Display, EightBitsAreRounded) {
  const FloatImage linear{2, 1, 3, {0, 1e9f, 0.18f, 0.18f, 0.5f, -1}};
  const FloatImage shown = displayed(linear, 0);
  const Image image = displayed_8_bit(linear, 0);
  for (size_t i = 0; i < 6; ++i) EXPECT_NEAR(image.rgba[i / 3 * 4 + i % 3], shown.values[i] * 255, 0.5) << i;
  EXPECT_EQ(image.rgba[3], 255);
}

} // namespace
} // namespace unghost
