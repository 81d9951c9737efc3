#include "app/measure/trail.h"

#include <functional>

#include <gtest/gtest.h>

namespace unghost {
namespace {

constexpr uint32_t side = 24;

FloatImage image_of(const std::function<float(uint32_t x, uint32_t y)>& value) {
  FloatImage image{.width = side, .height = side, .channels = 3, .values = {}};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x)
      for (int c = 0; c < 3; ++c) image.values.push_back(value(x, y));
  return image;
}

FloatImage mixed(const FloatImage& a, const FloatImage& b, float share) {
  FloatImage image = a;
  for (size_t i = 0; i < image.values.size(); ++i) image.values[i] += (b.values[i] - a.values[i]) * share;
  return image;
}

FloatImage noisy(float low, float high) {
  return image_of([=](uint32_t x, uint32_t y) { return (x * 7919u + y * 104729u) % 13u < 6u ? low : high; });
}

std::vector<PixelHistory> changed(Change change, uint8_t steady = 0) {
  return std::vector<PixelHistory>(side * side, {.steady_frames = steady, .change = change});
}

Trail trail(const FloatImage& aliased, const FloatImage& accumulated, const FloatImage& resolved,
            std::span<const PixelHistory> pixels) {
  TrailMeter meter(1, 0);
  meter.add(pixels, {.aliased = aliased, .accumulated = accumulated, .resolved = {&resolved}});
  return meter.trail_of(0);
}

const FloatImage road = image_of([](auto, auto) { return 0.2f; }),
                 ghost = image_of([](auto, auto) { return 0.02f; });

TEST(Trail, IsOneWhereTheWholeGhostIsLeft) {
  EXPECT_NEAR(*trail(road, ghost, ghost, changed(Change::surface)).whole, 1, 1e-6);
}

TEST(Trail, IsZeroWhereNothingOfItIs) {
  EXPECT_EQ(*trail(road, ghost, road, changed(Change::surface)).whole, 0);
}

TEST(Trail, DoesNotCountTheBlurOfARejectedPixel) {
  const FloatImage aliased = noisy(0.1f, 0.3f);
  FloatImage blurred = aliased;
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      float sum = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const uint32_t near_x = uint32_t(std::clamp(int(x) + dx, 0, int(side) - 1));
          const uint32_t near_y = uint32_t(std::clamp(int(y) + dy, 0, int(side) - 1));
          sum += aliased.values[(near_y * side + near_x) * 3] *
                 float((2 - std::abs(dx)) * (2 - std::abs(dy))) / 16;
        }
      for (uint32_t c = 0; c < 3; ++c) blurred.values[(y * side + x) * 3 + c] = sum;
    }
  EXPECT_NEAR(*trail(aliased, ghost, blurred, changed(Change::surface)).whole, 0, 1e-6);
}

TEST(Trail, GrowsWithTheShareThatIsLeft) {
  const FloatImage aliased = noisy(0.15f, 0.25f);
  double last = -1;
  for (const float share : {0.0f, 0.1f, 0.3f, 0.6f, 1.0f}) {
    const double now = *trail(aliased, ghost, mixed(aliased, ghost, share), changed(Change::surface)).whole;
    EXPECT_GT(now, last) << share;
    last = now;
  }
  EXPECT_LE(last, 1);
}

TEST(Trail, DoesNotCountWhatIsOnTheOtherSide) {
  const FloatImage brighter = image_of([](auto, auto) { return 0.5f; });
  EXPECT_EQ(*trail(road, ghost, brighter, changed(Change::surface)).whole, 0);
}

TEST(Trail, CountsOnlySurfacesAndShadowsThatChangedOfLate) {
  EXPECT_EQ(trail(road, ghost, ghost, changed(Change::surface, trail_frames)).whole, std::nullopt);
  EXPECT_EQ(trail(road, ghost, ghost, changed(Change::edge)).whole, std::nullopt);
  EXPECT_EQ(trail(road, ghost, ghost, changed(Change::start)).whole, std::nullopt);
  EXPECT_TRUE(trail(road, ghost, ghost, changed(Change::shadow, trail_frames - 1)).whole.has_value());
}

TEST(Trail, IsGivenApartForSurfacesAndShadows) {
  std::vector<PixelHistory> pixels = changed(Change::surface);
  for (size_t i = pixels.size() / 2; i < pixels.size(); ++i) pixels[i].change = Change::shadow;
  // The ghost is left in the upper half alone.
  const FloatImage resolved = image_of([](auto, uint32_t y) { return y < side / 2 ? 0.02f : 0.2f; });
  const Trail apart = trail(road, ghost, resolved, pixels);
  EXPECT_GT(*apart.surface, 0.8);
  EXPECT_LT(*apart.shadow, 0.2);
  EXPECT_NEAR(*apart.whole, (*apart.surface + *apart.shadow) / 2, 1e-6);
}

} // namespace
} // namespace unghost
