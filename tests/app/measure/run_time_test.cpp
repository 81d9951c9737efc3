#include "app/measure/run_time.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace unghost {
namespace {

ModeRun mode(const char* name) {
  ModeRun run{.name = name, .taa = find_taa_mode(name)->settings};
  run.taa.policy.jitter = Jitter::none;
  return run;
}

/// A device on which a naive resolve takes 10 ms, another 4 and without tests 3, a copy 2, motion 5, all
/// else 20.
struct Device {
  std::vector<FrameInput> drawn;
  Film film;
  bool sharpens = false;

  Device() {
    film.at = [](uint32_t frame) { return FrameInput{.index = frame}; };
    film.draw = [this](const FrameInput& input) {
      drawn.push_back(input);
      FrameResult result;
      for (const char* name : {"g-buffer", "light"}) result.passes.push_back({.name = name, .ms = 10});
      result.passes.push_back({.name = "motion", .ms = 5});
      result.passes.push_back({.name = "copy", .ms = 2});
      for (const ModeRun& run : input.modes)
        if (run.taa.policy.needs_history())
          result.passes.push_back({.name = "taa " + run.name, .ms = time_of(run.taa)});
      if (sharpens) result.passes.push_back({.name = "sharpen " + input.modes.front().name, .ms = 7});
      return result;
    };
  }
  static double time_of(const TaaSettings& taa) {
    if (taa.resolver == Resolver::naive) return 10;
    return taa.policy.reject == Reject::off_screen ? 3 : 4;
  }
};

TEST(RunTimes, AModeAddsItsResolveAndTheMotionItNeeds) {
  Device device;
  const RunTimes times = time_modes(device.film, {mode("off"), mode("blend"), mode("uncharted")}, 3);
  EXPECT_TRUE(times.modes[0].added_ms.empty()) << "off adds nothing";
  EXPECT_EQ(times.modes[1].added_ms, std::vector<double>(3, 3 + 5));
  EXPECT_EQ(times.modes[2].added_ms, std::vector<double>(3, 4 + 5));
  EXPECT_EQ(times.modes[2].over_copy, std::vector<double>(3, 2));
  EXPECT_EQ(times.modes[2].over_naive, std::vector<double>(3, 0.4));
  EXPECT_EQ(times.modes[2].over_no_rejection, std::vector<double>(3, 4.0 / 3));
  EXPECT_TRUE(times.modes[1].over_no_rejection.empty()) << "it has no tests";
  EXPECT_EQ(times.geometry_ms, std::vector<double>(3, 20)) << "once, whatever the number of modes";
  EXPECT_EQ(times.motion_ms, std::vector<double>(3, 5));
}

TEST(RunTimes, GeometryIsSharedByTheModesOfAFrame) {
  Device device;
  const Sharing sharing = time_sharing(device.film, {mode("blend"), mode("rgb"), mode("uncharted")}, 2);
  EXPECT_EQ(sharing.together_ms, 20 + 5 + 2 + 3 + 3 + 4);
  EXPECT_EQ(sharing.alone_ms, (std::vector<double>{20 + 5 + 2 + 3, 20 + 5 + 2 + 3, 20 + 5 + 2 + 4}));
}

TEST(RunTimes, SharpeningIsAddedWithoutAHistory) {
  Device device;
  ModeRun off = mode("off");
  off.taa.sharpen = 2;
  device.sharpens = true;
  const RunTimes times = time_modes(device.film, {off}, 2);
  EXPECT_EQ(times.modes[0].added_ms, std::vector<double>(2, 7)) << "and no motion";
  EXPECT_EQ(times.modes[0].added_over_copy, std::vector<double>(2, 3.5));
}

TEST(RunTimes, TheModesKeepTheirPlacesWhenTheOthersAreNoLongerDrawn) {
  Device device;
  const RunTimes times = time_modes(device.film, {mode("blend"), mode("uncharted")}, 100);
  EXPECT_EQ(times.modes[1].added_ms.size(), 100u);
  EXPECT_LT(times.modes[1].over_naive.size(), 100u);
  EXPECT_GT(times.modes[1].over_naive.size(), 31u);
  EXPECT_EQ(device.drawn.front().modes.size(), 5u) << "two, two naively, one without its tests";
  EXPECT_EQ(device.drawn.back().modes.size(), 2u);
  for (const FrameInput& input : device.drawn) {
    EXPECT_TRUE(input.timed);
    for (size_t i = 0; i < 2; ++i) EXPECT_EQ(input.modes[i].name, device.drawn.back().modes[i].name);
  }
}

} // namespace
} // namespace unghost
