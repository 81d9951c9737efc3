// When frames may be skipped: that what rests settles as promised, and that what moves is drawn.
#include "renderer/stillness.h"

#include <algorithm>
#include <map>

#include "renderer/view.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Settling : public StudioTest {};

/// The largest difference of any channel, in 255ths.
int difference(const Image& a, const Image& b) {
  int most = 0;
  for (size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(int(a.rgba[i]) - int(b.rgba[i])));
  return most;
}

TEST_F(Settling, PicturesRepeatThemselvesFromThenOn) {
  std::map<std::pair<uint32_t, uint32_t>, std::vector<ModeRun>> runs; // by when they settle, and their cycle
  for (const TaaMode& mode : taa_modes())
    if (const auto settled = frames_until_settled(mode.settings))
      runs[{*settled, jitter_cycle(mode.settings.policy.jitter)}].push_back(run_of(mode.name));
  for (const auto& [when, modes] : runs) {
    const auto [settled, cycle] = when;
    std::vector<Wanted> wanted;
    for (size_t mode = 0; mode < modes.size(); ++mode) wanted.push_back({Output::display, mode});
    std::vector<std::vector<Delivered>> frames;
    for (uint32_t index = 0; index < settled + 2 * cycle; ++index) {
      FrameInput input =
          studio->frame("still", int(index), modes, index + 1 < settled ? std::vector<Wanted>{} : wanted);
      input.width = 96, input.height = 54;
      frames.push_back(studio->renderer.render(input).delivered);
    }
    for (size_t mode = 0; mode < modes.size(); ++mode)
      for (uint32_t index = settled - 1; index < settled + cycle; ++index)
        EXPECT_LE(difference(frames[index][mode].picture, frames[index + cycle][mode].picture), 1)
            << modes[mode].name << " after " << settled;
  }
}

TEST_F(Settling, TakesLongerTheLessANewFrameWeighs) {
  const auto frames = [](const char* mode, float alpha) {
    TaaSettings taa = run_of(mode).taa;
    taa.alpha = alpha;
    return frames_until_settled(taa).value();
  };
  EXPECT_EQ(frames("off", 0.1f), 1u);
  EXPECT_EQ(frames("blend", 1), 8u) << "a whole cycle of the jitter";
  EXPECT_EQ(frames("blend", 0.1f), 64u) << ".9^60 is below 1/512";
  EXPECT_GT(frames("blend", 0.05f), frames("blend", 0.1f));
  EXPECT_LE(frames("crytek-2x", 0.5f), 4u) << "two inputs";
  EXPECT_EQ(frames_until_settled(run_of("dop32").taa), std::nullopt) << "clipped, it never settles";
  EXPECT_NE(frames_until_settled(run_of("unghost").taa), std::nullopt) << "at rest it is not clipped";
}

TEST_F(Settling, WhatMovesIsDrawnAndSaid) {
  Stillness still(false);
  const auto next = [&](const char* rig, int index, auto change) {
    FrameInput input = studio->frame(rig, index, {run_of("blend")}, {});
    change(input);
    return still.frames_left(input);
  };
  const auto nothing = [](FrameInput&) {};
  for (int index = 0; index < 64; ++index) EXPECT_EQ(next("still", index, nothing), uint32_t(64 - index));
  EXPECT_EQ(next("still", 64, nothing), 0u);
  EXPECT_EQ(next("still", 65, [](FrameInput& input) { input.settings.light.exposure_ev = 1; }), 64u);
  EXPECT_EQ(still.change(), "the settings change");
  EXPECT_EQ(next("rotate", 66, nothing), 64u);
  EXPECT_EQ(still.change(), "the camera moves");
  Stillness parked(false);
  parked.frames_left(studio->frame("pass", 20, {run_of("off")}, {}));
  EXPECT_EQ(parked.change(), "the vehicle moves");
}

} // namespace
} // namespace unghost
