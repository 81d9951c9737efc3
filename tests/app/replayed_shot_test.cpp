#include "app/replayed_shot.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "app/png_file.h"
#include "tests/app/drawn_path.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

class ReplayWords : public testing::Test {
protected:
  Outcome replayed(const std::string& command, const Words& more) const {
    Words words = {command, "--replay", file, "-o", (folder.path / "a.png").string()};
    words.insert(words.end(), more.begin(), more.end());
    return outcome(words);
  }

  ScratchFolder folder;
  std::string file = folder.file("path.json", drawn_path().recorder.text()).string();
};

TEST_F(ReplayWords, WhatTheFileSaysIsNotSaidTwice) {
  for (const Words& more : {Words{"car.glb"}, Words{"--rig", "drive"}, Words{"--seed", "1"},
                            Words{"--size", "10x10"}, Words{"--settings", file}}) {
    const Outcome run = replayed("capture", more);
    EXPECT_EQ(run.exit, int(Exit::wrong_words)) << more[0];
    EXPECT_NE(run.err.find("does not go with --replay"), std::string::npos) << run.err;
  }
  for (const char* command : {"measure", "bench", "explain"})
    EXPECT_NE(outcome({command, "--replay", file}).err.find("there is no option '--replay'"),
              std::string::npos);
}

TEST_F(ReplayWords, FramesAndModesThatItDoesNotHaveAreRefused) {
  const std::tuple<const char*, Words, const char*> wrong[] = {
      {"capture", {"--frames", "10"}, "--frames 10 is beyond the last of 9 recorded frames"},
      {"capture", {"--frames", "6"}, "shows blend, dop32, off in frame 5 of its frames: --mode says which"},
      {"capture", {"--mode", "bland"}, "did you mean 'blend'?"},
      {"compare", {}, "shows blend in frame 8 of its frames: --modes says which"},
      {"compare", {"--modes", "blend,blend"}, "more than once"},
      {"compare", {"--modes", "off,blend:alpha=0.2"}, "blend:alpha=0.2 does not go with --replay"}};
  for (const auto& [command, more, sentence] : wrong) {
    const Outcome run = replayed(command, more);
    EXPECT_EQ(run.exit, int(Exit::wrong_words)) << sentence;
    EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
  }
}

class ReplayedShot : public ReplayWords {
protected:
  Shot shot_of(const std::string& command, const Words& more) const {
    Words words = {command, "--replay", file};
    words.insert(words.end(), more.begin(), more.end());
    return shot_from(command_line_of(words));
  }
  std::string complaint(const std::string& command, const Words& more) const {
    try {
      shot_of(command, more);
    } catch (const SettingError& error) {
      return error.what();
    }
    return {};
  }
};

TEST_F(ReplayedShot, WhatIsSetIsSetInAllFramesAndNothingElseIs) {
  const Shot as_recorded = shot_of("capture", {}),
             shot = shot_of("capture", {"--view", "tag", "--set", "exposure=-1", "--set", "alpha=0.3"});
  const Recording &before = as_recorded.replay->recording, &after = shot.replay->recording;
  ASSERT_EQ(after.frames.size(), before.frames.size());
  for (size_t i = 0; i < after.frames.size(); ++i) {
    SCOPED_TRACE(i);
    FrameInput expected = frame_input(before, {}, i);
    expected.settings.view = View::tag;
    expected.settings.light.exposure_ev = -1;
    for (ModeRun& run : expected.modes)
      if (run.name != "off") run.taa.alpha = 0.3f; // which mixes nothing
    FrameInput input = frame_input(after, {}, i);
    input.settings.taa = expected.settings.taa; // which is not read
    expect_same(input, expected);
  }
  EXPECT_EQ(shot.settings.view, View::tag);
  EXPECT_EQ(shot.modes.front().taa.alpha, 0.3f);
}

TEST_F(ReplayedShot, WhatIsSetToWhatWasRecordedChangesNothing) {
  const Shot as_recorded = shot_of("demo", {}), shot = shot_of("demo", {"--set", "speed=1", "--frames", "9"});
  const FrameInput first = frame_input(as_recorded.replay->recording, {}, 0);
  ASSERT_EQ(first.settings.stage.speed, 1);
  expect_same(frame_input(shot.replay->recording, {}, 0), first);
}

TEST_F(ReplayedShot, WhatHasAnEffectInSomeFramesIsSetThere) {
  const Shot shot =
      shot_of("capture", {"--set", "axes=dop16"}); // of one of the modes, in three of nine frames
  const Recording& recording = shot.replay->recording;
  size_t set = 0, kept = 0;
  for (const Look& look : recording.looks)
    for (const ModeRun& run : shown_modes(look)) {
      const TaaSettings& row = settings_for_mode(run.name).taa;
      (run.name == "dop32" ? set : kept) += 1;
      EXPECT_EQ(run.taa.policy.axes == row.policy.axes, run.name != "dop32") << run.name;
    }
  EXPECT_GT(set, 0u);
  EXPECT_GT(kept, set);
}

TEST_F(ReplayedShot, WhatCannotBeSetIsRefusedWithTheReason) {
  const std::tuple<const char*, Words, const char*> wrong[] = {
      {"capture", {"--view", "colr"}, "did you mean 'colour'?"},
      {"capture", {"--set", "son=1"}, "did you mean 'sun'?"},
      {"capture", {"--set", "sun"}, "name=value"},
      {"capture", {"--set", "sun=1000"}, "from 0 to 100"},
      {"capture", {"--mode", "off", "--set", "alpha=0.5"}, "alpha=0.5 has no effect: blend=current"},
      {"capture", {"--set", "blend=attenuated"}, "blend: blend=attenuated acts"}};
  for (const auto& [command, more, sentence] : wrong)
    EXPECT_NE(complaint(command, more).find(sentence), std::string::npos)
        << sentence << ": " << complaint(command, more);
}

TEST_F(ReplayedShot, APictureOfItSaysWhatItIsOfAndIsNoSettings) {
  const Shot shot = shot_of("capture", {"--view", "motion"});
  const nlohmann::json carried = shot_json(shot, shot.frames);
  EXPECT_EQ(carried["replay"], file);
  EXPECT_EQ(carried["set"], nlohmann::json({"view=motion"}));
  const Image pixel{.name = "", .width = 1, .height = 1, .rgba = {1, 2, 3, 255}};
  const std::vector<uint8_t> png = encode_png(pixel, carried.dump());
  const std::string picture = folder.file("replayed.png", {png.begin(), png.end()}).string();
  const Outcome run = outcome({"capture", "--settings", picture, "-o", (folder.path / "again.png").string()});
  EXPECT_EQ(run.exit, int(Exit::input_refused));
  EXPECT_EQ(run.err, "unghost: " + picture +
                         ": it is of a path that was replayed: --replay with that file draws it again\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path / "again.png"));
}

} // namespace
} // namespace unghost
