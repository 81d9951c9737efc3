// Views that are kept, and paths that the real demo records and replays: to the bit, also without a window.
#include "tests/window/recorded_demo.h"

namespace unghost {
namespace {

using nlohmann::json;

class DemoPath : public RecordedDemo {
protected:
  /// While it is paused: one frame is drawn.
  static void go_to_bookmark(DemoRun& run) {
    const uint64_t before = run.press("j", "bookmark")["drawn"];
    EXPECT_TRUE(comes_true([&] { return drawn(run) > before; }));
  }
};

TEST_F(DemoPath, ARecordingIsDrawnWithoutAWindowToTheBit) {
  configure({{"rig", "drive"}, {"shown", "blend"}});
  DemoRun run = started();
  draw_more(run, 10); // of a history that is no part of it
  run.press("o", "recording");
  draw_more(run, 10);
  run.window().drag({100, 60}, {180, 90});
  run.press("3", "mode");
  run.press("x", "rectification");
  draw_more(run, 5);
  run.press("BackSpace", "history");
  run.press("l", "rig");
  run.window().scroll(2);
  draw_more(run, 5);
  EXPECT_EQ(end(run), "unghost-path-1.json");
  expect_left_in_silence(run);
  EXPECT_EQ(without_window({"capture", "--replay", "unghost-path-1.json", "-o", "replayed.png"}), 0);
  expect_same("replayed.png", "unghost-1.png");
  EXPECT_EQ(without_window({"capture", "--replay", "unghost-path-1.json", "--mode", "off", "-o", "off.png"}),
            0);
  EXPECT_NE(pixels_of("off.png"), pixels_of("replayed.png"));
  EXPECT_EQ(without_window({"capture", "--replay", "unghost-path-1.json", "--view", "motion", "--set",
                            "sun=1", "-o", "motion.png"}),
            0);
  EXPECT_NE(pixels_of("motion.png"), pixels_of("replayed.png"));
  EXPECT_EQ(without_window({"capture", "--replay", "unghost-path-1.json", "--set", "sun=1", "-o", "lit.png"}),
            0);
  expect_same("lit.png", "replayed.png"); // as it was recorded
}

TEST_F(DemoPath, AReplayInTheWindowEndsAtTheSamePicture) {
  configure({{"rig", "drive"}, {"shown", "blend"}});
  DemoRun run = started();
  run.press("o", "recording");
  run.window().drag({100, 60}, {180, 90});
  draw_more(run, 10);
  run.press("9", "mode");
  draw_more(run, 3);
  end(run);
  run.press("4", "mode"); // and is elsewhere meanwhile
  run.press("l", "rig");
  run.press("shift+o", "replay");
  EXPECT_TRUE(run.expect_event("replayed")["message"].get<std::string>().ends_with("; P goes on"));
  take(run, "unghost-2.png");
  expect_same("unghost-2.png", "unghost-1.png");
  expect_left_in_silence(run);
}

TEST_F(DemoPath, ANamedRecordingIsReplayedAtOnceAndLeavesThePersonsSettings) {
  configure({{"rig", "pass"}, {"shown", "blend"}});
  {
    DemoRun run = started();
    run.press("o", "recording");
    draw_more(run, 10);
    end(run);
    expect_left_in_silence(run);
  }
  configure({{"rig", "still"}, {"shown", "off"}});
  DemoRun run = started(small, {"--replay", "unghost-path-1.json"});
  run.expect_event("replayed");
  EXPECT_EQ(run.press("m", "bookmark")["state"]["rig"], "pass");
  take(run, "unghost-2.png");
  expect_same("unghost-2.png", "unghost-1.png");
  expect_left_in_silence(run);
  const json kept = json::parse(content_of(config_file()));
  EXPECT_EQ(kept["rig"], "still");
  EXPECT_EQ(kept["shown"], "off");
  EXPECT_EQ(kept["bookmarks"].size(), 1u);
}

TEST_F(DemoPath, OtherSizesAndAComparisonArePartOfIt) {
  configure({{"rig", "drive"}, {"shown", "blend"}, {"compared", {"dop32"}}});
  DemoRun run = started();
  run.press("o", "recording");
  draw_more(run, 5);
  run.window().resize({400, 220});
  run.window().expect_size({400, 220});
  run.press("b", "comparison");
  draw_more(run, 5);
  run.press("b", "comparison");
  draw_more(run, 5);
  end(run);
  expect_left_in_silence(run);
  EXPECT_EQ(without_window({"capture", "--replay", "unghost-path-1.json", "-o", "replayed.png"}), 0);
  expect_same("replayed.png", "unghost-1.png");
  EXPECT_EQ(without_window(
                {"compare", "--replay", "unghost-path-1.json", "--modes", "blend,off", "-o", "grid.png"}),
            0);
}

/// Where nothing moves, shadows are kept from frame to frame, and those of before are no part of a recording.
TEST_F(DemoPath, WhatRestsIsRecordedFromAColdStart) {
  configure({{"rig", "still"}, {"shown", "off"}});
  DemoRun run = started();
  for (const int to : {140, 120, 180, 160}) {
    run.window().drag({100, 60}, {to, 90});
    draw_more(run, 2);
  }
  run.press("o", "recording");
  draw_more(run, 3);
  end(run);
  expect_left_in_silence(run);
  EXPECT_EQ(without_window({"capture", "--replay", "unghost-path-1.json", "-o", "replayed.png"}), 0);
  expect_same("replayed.png", "unghost-1.png");
}

TEST_F(DemoPath, ARecordingIsWrittenWhereTheDemoIsLeft) {
  DemoRun run = started();
  run.press("o", "recording");
  draw_more(run, 3);
  expect_left_in_silence(run);
  EXPECT_TRUE(std::filesystem::exists(folder.path / "unghost-path-1.json"));
}

TEST_F(DemoPath, ABookmarkBringsTheSamePictureAgain) {
  configure({{"rig", "drive"}, {"shown", "off"}});
  DemoRun run = started();
  run.window().drag({100, 60}, {180, 90});
  draw_more(run, 2); // with the camera where it was dragged to
  run.press("p", "pause");
  run.press("m", "bookmark");
  const Picture kept = later_picture(run);
  // a frame that follows others has shadows that they drew, from where they saw them: they round otherwise
  go_to_bookmark(run);
  take(run, "unghost-1.png");
  run.press("p", "pause");
  run.press("Home", "camera");
  run.press("l", "rig");
  draw_more(run, 3);
  run.press("p", "pause");
  go_to_bookmark(run);
  take(run, "unghost-2.png");
  expect_same("unghost-2.png", "unghost-1.png");
  EXPECT_TRUE(comes_back(run, kept));
  expect_left_in_silence(run);
}

} // namespace
} // namespace unghost
