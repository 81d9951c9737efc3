#include "app/measure/flicker.h"

#include <functional>

#include <gtest/gtest.h>

namespace unghost {
namespace {

constexpr uint32_t width = 8, height = 6;

FloatImage image_of(uint32_t channels, const std::function<float(uint32_t x, uint32_t y)>& value) {
  FloatImage image{.width = width, .height = height, .channels = channels, .values = {}};
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) image.values.insert(image.values.end(), channels, value(x, y));
  return image;
}

FloatImage motion_of(float dx, float dy) {
  FloatImage motion{.width = width, .height = height, .channels = 2, .values = {}};
  for (uint32_t i = 0; i < width * height; ++i) motion.values.insert(motion.values.end(), {dx, dy});
  return motion;
}

const std::vector<PixelHistory> steady(width* height, {.steady_frames = 9, .change = Change::start});

float slope(uint32_t x, uint32_t y) { return 0.01f * float(x) + 0.02f * float(y); }

TEST(Flicker, AnErrorThatMovesWithItsSurfaceDoesNotFlicker) {
  // last frame's pixel is 1.5 to the right and half a pixel above
  const FloatImage before = image_of(3, slope),
                   now = image_of(3, [](uint32_t x, uint32_t y) {
                     return 0.01f * (float(x) + 1.5f) + 0.02f * (float(y) - 0.5f);
                   });
  std::vector<PixelHistory> inside = steady; // where the edge does not go on
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      if (x + 2 >= width || y == 0) inside[y * width + x] = {.change = Change::edge};
  EXPECT_NEAR(*flicker_between(before, now, motion_of(1.5f, -0.5f), inside), 0, 1e-7);
  EXPECT_GT(*flicker_between(before, now, motion_of(0, 0), inside), 0.004) << "without its motion";
}

TEST(Flicker, IsTheMeanChangeOverPixelsThatBothFramesShow) {
  const FloatImage nothing = image_of(3, [](uint32_t, uint32_t) { return 0.0f; });
  const FloatImage half = image_of(3, [](uint32_t x, uint32_t) { return x < width / 2 ? 0.5f : 0.1f; });
  EXPECT_NEAR(*flicker_between(nothing, half, motion_of(0, 0), steady), 0.3, 1e-7);
  std::vector<PixelHistory> left = steady;
  for (uint32_t i = 0; i < width * height; ++i)
    if (i % width >= width / 2) left[i] = {.steady_frames = 0, .change = Change::surface};
  EXPECT_NEAR(*flicker_between(nothing, half, motion_of(0, 0), left), 0.5, 1e-7);
  for (PixelHistory& pixel : left) pixel = {.steady_frames = 0, .change = Change::shadow};
  EXPECT_NEAR(*flicker_between(nothing, half, motion_of(0, 0), left), 0.3, 1e-7) << "the surface is seen";
  for (PixelHistory& pixel : left) pixel = {.steady_frames = 0, .change = Change::edge};
  EXPECT_FALSE(flicker_between(nothing, half, motion_of(0, 0), left));
}

TEST(Flicker, ExcessIsSigned) {
  const Image dark{.name = {}, .width = 1, .height = 1, .rgba = {0, 51, 255, 255}},
      light{.name = {}, .width = 1, .height = 1, .rgba = {255, 0, 255, 0}};
  const FloatImage image = excess(dark, light);
  EXPECT_EQ(image.values, (std::vector<float>{-1, 0.2f, 0}));
}

} // namespace
} // namespace unghost
