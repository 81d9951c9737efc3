#include "app/measure/steadiness.h"

#include <gtest/gtest.h>

namespace unghost {
namespace {

constexpr uint32_t width = 16, height = 8;
constexpr float road = 1, car = 2;

FloatImage plain(uint32_t channels, float value) {
  return {.width = width,
          .height = height,
          .channels = channels,
          .values = std::vector<float>(size_t(width) * height * channels, value)};
}

/// A wall 10 m away that rests, in the sun.
Surfaces wall() {
  return {.depth = plain(1, 10),
          .previous_depth = plain(1, 10),
          .motion = plain(2, 0),
          .object = plain(1, road),
          .sun_visibility = plain(1, 1)};
}

/// The same with something 5 m away over the columns [from, from + 4).
Surfaces wall_behind_car(uint32_t from, float car_motion_px) {
  Surfaces surfaces = wall();
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = from; x < from + 4; ++x) {
      const size_t at = y * width + x;
      surfaces.depth.values[at] = surfaces.previous_depth.values[at] = 5;
      surfaces.object.values[at] = car;
      surfaces.motion.values[at * 2] = car_motion_px;
    }
  return surfaces;
}

PixelHistory pixel(const Steadiness& steadiness, uint32_t x, uint32_t y = 4) {
  return steadiness.pixels()[y * width + x];
}

TEST(Steadiness, CountsFramesOfWhatRests) {
  Steadiness steadiness;
  for (int frame = 0; frame < 300; ++frame) steadiness.advance(wall());
  EXPECT_EQ(pixel(steadiness, 3).steady_frames, 255);
  EXPECT_EQ(pixel(steadiness, 3).change, Change::start);
}

TEST(Steadiness, FindsWhatACarUncoversAndTheCarItselfSteady) {
  Steadiness steadiness;
  for (uint32_t frame = 0; frame < 4; ++frame) steadiness.advance(wall_behind_car(2 + 2 * frame, -2));
  EXPECT_EQ(pixel(steadiness, 6).steady_frames, 0) << "just uncovered";
  EXPECT_EQ(pixel(steadiness, 6).change, Change::surface);
  EXPECT_EQ(pixel(steadiness, 4).steady_frames, 1) << "uncovered a frame ago";
  EXPECT_EQ(pixel(steadiness, 1).change, Change::start) << "never covered";
  EXPECT_EQ(pixel(steadiness, 9).steady_frames, 3) << "the car";
}

TEST(Steadiness, TellsShadowsFromSurfaces) {
  Steadiness steadiness;
  steadiness.advance(wall());
  Surfaces shaded = wall();
  shaded.sun_visibility = plain(1, 0);
  steadiness.advance(shaded);
  EXPECT_EQ(pixel(steadiness, 5).change, Change::shadow);
  EXPECT_EQ(pixel(steadiness, 5).steady_frames, 0);
  steadiness.advance(shaded);
  EXPECT_EQ(pixel(steadiness, 5).steady_frames, 1);
}

TEST(Steadiness, WhatEntersAtTheEdgeIsNoGhost) {
  Steadiness steadiness;
  steadiness.advance(wall());
  Surfaces panned = wall();
  for (size_t i = 0; i < panned.motion.values.size(); i += 2) panned.motion.values[i] = 3;
  steadiness.advance(panned);
  EXPECT_EQ(pixel(steadiness, width - 2).change, Change::edge);
  EXPECT_EQ(pixel(steadiness, 2).steady_frames, 1);
}

TEST(Steadiness, AllowsForSlopesAndNotForSteps) {
  const auto slope = [](float shift) {
    Surfaces surfaces = wall();
    for (uint32_t y = 0; y < height; ++y)
      for (uint32_t x = 0; x < width; ++x) {
        surfaces.depth.values[y * width + x] = 10 + 2 * float(x);
        surfaces.previous_depth.values[y * width + x] = 10 + 2 * (float(x) + shift);
        surfaces.motion.values[(y * width + x) * 2] = shift;
      }
    return surfaces;
  };
  Steadiness steadiness;
  steadiness.advance(slope(0));
  steadiness.advance(slope(0.5f));
  EXPECT_EQ(pixel(steadiness, 8).steady_frames, 1);
  Surfaces nearer = slope(0.5f);
  for (float& depth : nearer.previous_depth.values) depth -= 4;
  steadiness.advance(nearer);
  EXPECT_EQ(pixel(steadiness, 8).change, Change::surface);
}

TEST(Steadiness, SkyIsSteadyUnlessItWasCovered) {
  const auto sky = [] {
    Surfaces surfaces = wall();
    surfaces.object = plain(1, 0);
    surfaces.depth = surfaces.previous_depth = plain(1, INFINITY);
    return surfaces;
  };
  Steadiness steadiness;
  steadiness.advance(sky());
  steadiness.advance(sky());
  EXPECT_EQ(pixel(steadiness, 5).steady_frames, 1);
  steadiness.advance(wall());
  steadiness.advance(sky());
  EXPECT_EQ(pixel(steadiness, 5).change, Change::surface);
}

TEST(Steadiness, MotionWithoutMeaningIsOutside) {
  Steadiness steadiness;
  steadiness.advance(wall());
  Surfaces broken = wall();
  for (float& motion : broken.motion.values) motion = NAN;
  steadiness.advance(broken);
  EXPECT_EQ(pixel(steadiness, 5).change, Change::edge);
}

} // namespace
} // namespace unghost
