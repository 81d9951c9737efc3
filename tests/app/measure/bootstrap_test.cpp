#include "app/measure/bootstrap.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace unghost {
namespace {

FrameShares mean_of(std::vector<double> values) {
  const size_t count = values.size();
  return {.parts = std::move(values), .wholes = std::vector<double>(count, 1)};
}

constexpr FramePairing apart{.paired = true, .successive = false};

// Two frames: each is drawn twice in a quarter of all resamples, so the percentiles are the two themselves,
// 1.1 and 1.3; around the mean .2 they lie twice .1, which 12.706 / 1.960 * sqrt(2 / 1) makes .9168.
TEST(Bootstrap, TwoFramesByHand) {
  const RelativeChange found = change_of_frames(mean_of({1, 1}), mean_of({1.1, 1.3}), apart, 0.001);
  EXPECT_NEAR(found.change, 0.2, 1e-12);
  EXPECT_NEAR(found.low, 0.2 - 0.9168, 1e-4);
  EXPECT_NEAR(found.high, 0.2 + 0.9168, 1e-4);
}

// Three: the lowest is drawn three times in 1 of 27, which is more than 2.5%. 4.303 / 1.960 * sqrt(3 / 2).
TEST(Bootstrap, ThreeFramesByHand) {
  const RelativeChange found = change_of_frames(mean_of({2, 2, 2}), mean_of({2.2, 2.4, 2.6}), apart, 0.001);
  EXPECT_NEAR(found.change, 0.2, 1e-12);
  EXPECT_NEAR(found.low, 0.2 - 0.1 * 2.6888, 1e-4);
  EXPECT_NEAR(found.high, 0.2 + 0.1 * 2.6888, 1e-4);
}

// Of four blocks of four, rotations of 16 frames that rise and fall alike: a block that begins anywhere holds
// every phase once, so that nothing varies between resamples. Drawn one by one, they would.
TEST(Bootstrap, NeighboursAreDrawnTogether) {
  std::vector<double> before(16, 1), after;
  for (int i = 0; i < 16; ++i) after.push_back(1 + 0.1 * (i % 4));
  const RelativeChange blocks = change_of_frames(mean_of(before), mean_of(after), {}, 0.001);
  EXPECT_NEAR(blocks.low, 0.15, 1e-9);
  EXPECT_NEAR(blocks.high, 0.15, 1e-9);
  const RelativeChange single = change_of_frames(mean_of(before), mean_of(after), apart, 0.001);
  EXPECT_LT(single.low, 0.11);
  EXPECT_GT(single.high, 0.19);
}

TEST(Bootstrap, PairsTakeOutWhatBothFramesShare) {
  std::vector<double> before, after;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(0.01, 0.09);
  for (int i = 0; i < 100; ++i) before.push_back(any(random)), after.push_back(before.back() * 1.02);
  const RelativeChange paired = change_of_frames(mean_of(before), mean_of(after), {}, 0.001);
  EXPECT_NEAR(paired.low, 0.02, 1e-9);
  EXPECT_NEAR(paired.high, 0.02, 1e-9);
  const RelativeChange unpaired =
      change_of_frames(mean_of(before), mean_of(after), {.paired = false, .successive = true}, 0.001);
  EXPECT_LT(unpaired.low, 0);
  EXPECT_GT(unpaired.high, 0.04);
}

TEST(Bootstrap, AShareIsOfSums) {
  const FrameShares before{.parts = {1, 0, 3}, .wholes = {10, 0, 10}};
  EXPECT_DOUBLE_EQ(share_of(before), 0.2);
  EXPECT_DOUBLE_EQ(share_of({.parts = {0, 0}, .wholes = {0, 0}}), 0);
  const FrameShares after{.parts = {2, 0, 6}, .wholes = {10, 0, 10}};
  const RelativeChange found = change_of_frames(before, after, apart, 0.01);
  EXPECT_DOUBLE_EQ(found.change, 1);
}

TEST(Bootstrap, WhatIsNearNothingChangesByWhatCanBeRead) {
  EXPECT_DOUBLE_EQ(relative_change(0, 0, 0.001), 0);
  EXPECT_DOUBLE_EQ(relative_change(0, 0.0001, 0.001), 0.1);
  EXPECT_DOUBLE_EQ(relative_change(0.0005, 0, 0.001), -0.5);
  EXPECT_DOUBLE_EQ(relative_change(0.002, 0.003, 0.001), 0.5);
}

TEST(Bootstrap, TheSameEveryTime) {
  const FrameShares before = mean_of({1, 2, 3, 4, 5, 6, 7, 8, 9}),
                    after = mean_of({1, 3, 2, 5, 4, 6, 8, 7, 9.5});
  const RelativeChange first = change_of_frames(before, after, {}, 0.001),
                       second = change_of_frames(before, after, {}, 0.001);
  EXPECT_EQ(first.low, second.low);
  EXPECT_EQ(first.high, second.high);
}

// Medians of three rounds: the lowest is the median where it is drawn twice or thrice, in 7 of 27.
TEST(Bootstrap, MediansByHand) {
  const RelativeChange found = change_of_medians({2, 2, 2}, {3, 2.5, 2.2}, 0.1);
  EXPECT_NEAR(found.change, 0.25, 1e-12);
  EXPECT_NEAR(found.low, 0.1, 1e-12);
  EXPECT_NEAR(found.high, 0.5, 1e-12);
}

struct Noise {
  int frames;
  double likeness; // of neighbours: the correlation
  bool paired, successive;
};

/// How often nothing but noise is called a change, in percent.
double false_alarms(const Noise& noise) {
  int alarms = 0;
  constexpr int seeds = 600;
  for (int seed = 0; seed < seeds; ++seed) {
    std::mt19937 random{unsigned(seed)};
    std::normal_distribution<double> normal;
    const auto wandering = [&] {
      std::vector<double> values;
      double at = normal(random);
      for (int i = 0; i < noise.frames; ++i) {
        values.push_back(1 + 0.05 * at);
        at = noise.likeness * at + std::sqrt(1 - noise.likeness * noise.likeness) * normal(random);
      }
      return mean_of(values);
    };
    const FrameShares before = wandering(), after = wandering();
    const RelativeChange found =
        change_of_frames(before, after, {.paired = noise.paired, .successive = noise.successive}, 0.001);
    alarms += found.low > 0 || found.high < 0;
  }
  return 100.0 * alarms / seeds;
}

TEST(Bootstrap, NoiseIsCalledAChangeOneTimeInTwenty) {
  for (const Noise& noise : {Noise{100, 0, true, true}, Noise{100, 0.3, true, true}, Noise{16, 0, true, true},
                             Noise{8, 0, true, false}, Noise{5, 0, true, false}, Noise{2, 0, true, false},
                             Noise{40, 0, false, true}}) {
    const double percent = false_alarms(noise);
    EXPECT_GT(percent, 1) << noise.frames << " frames alike by " << noise.likeness;
    EXPECT_LT(percent, 10) << noise.frames << " frames alike by " << noise.likeness;
  }
}

TEST(Bootstrap, NoiseOfTimesIsCalledAChangeOneTimeInTwenty) {
  int alarms = 0;
  constexpr int seeds = 400;
  for (int seed = 0; seed < seeds; ++seed) {
    std::mt19937 random{unsigned(seed)};
    std::lognormal_distribution<double> times(1, 0.1);
    std::vector<double> before, after;
    for (int i = 0; i < 31; ++i) before.push_back(times(random)), after.push_back(times(random));
    const RelativeChange found = change_of_medians(before, after, 0.1);
    alarms += found.low > 0 || found.high < 0;
  }
  EXPECT_GT(alarms, seeds / 100);
  EXPECT_LT(alarms, 9 * seeds / 100);
}

} // namespace
} // namespace unghost
