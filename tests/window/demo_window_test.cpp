// What the real demo's window shows, and what can be done to a window.
#include "tests/window/driven_demo.h"

namespace unghost {
namespace {

using nlohmann::json;

/// Nothing moves in it, and without TAA no frame differs from the one before.
const json still = {{"rig", "still"}, {"shown", "off"}};

class DemoPictures : public DrivenDemo {
protected:
  void SetUp() override {
    DrivenDemo::SetUp();
    if (desk) configure(still);
  }
};
class DemoScreenshot : public DemoPictures {};
class DemoWindow : public DemoPictures {};

TEST_F(DemoPictures, TaaAndMagnifierAndViewsAreSeen) {
  DemoRun run = started();
  const Picture before = later_picture(run);
  EXPECT_EQ(difference(later_picture(run), before), 0);
  for (const auto& [there, back, action, share] : {std::tuple{"Return", "Return", "TAA", 0.005},
                                                   {"v", "v", "magnifier", 0.02},
                                                   {"n", "shift+n", "view", 0.2},
                                                   {"h", "h", "keys", 0.1}}) {
    run.press(there, action);
    EXPECT_TRUE(comes_to_differ(run, before, share)) << action;
    run.press(back, action);
    EXPECT_TRUE(comes_back(run, before)) << action;
  }
  expect_left_in_silence(run);
}

TEST_F(DemoPictures, NothingMovesOnceItRests) {
  configure({{"rig", "drive"}, {"shown", "off"}});
  DemoRun run = started();
  EXPECT_TRUE(comes_to_differ(run, run.window().picture(), 0.01));
  run.press("Tab", "movement");
  const Picture resting = later_picture(run);
  EXPECT_EQ(difference(later_picture(run), resting), 0);
  run.press("Tab", "movement");
  EXPECT_TRUE(comes_to_differ(run, resting, 0.01));
  run.press("p", "pause");
  const Picture paused = later_picture(run);
  EXPECT_EQ(difference(later_picture(run), paused), 0);
  run.press("period", "one frame");
  EXPECT_TRUE(comes_to_differ(run, paused, 0));
  expect_left_in_silence(run);
}

TEST_F(DemoPictures, ADroppedHistoryIsSeenInTheNextFrame) {
  configure({{"rig", "still"}, {"shown", "blend"}});
  DemoRun run = started();
  EXPECT_TRUE(comes_true([&] { return asked(run)["drawn"] >= 60; })) << "it has gathered one";
  run.press("p", "pause");
  const Picture gathered = later_picture(run);
  run.press("period", "one frame");
  EXPECT_LT(difference(later_picture(run), gathered), 0.002);
  EXPECT_EQ(run.press("BackSpace", "history")["message"], "history: dropped");
  EXPECT_LT(difference(later_picture(run), gathered), 0.002);
  run.press("period", "one frame");
  EXPECT_TRUE(comes_to_differ(run, gathered, 0.005));
  expect_left_in_silence(run);
}

/// Whether there is white writing, in letters as high as a line, in that part of the window's upper edge.
bool has_label(const Picture& picture, int from, int to) {
  size_t white = 0;
  for (int y = 4; y < 24; ++y)
    for (int x = from; x < to; ++x) {
      const auto& [r, g, b] = picture.at({x, y});
      white += r > 250 && g > 250 && b > 250;
    }
  return white > 40;
}

Picture half(const Picture& picture, bool right) {
  const int width = picture.size.width, from = right ? width / 2 + 4 : 0, to = right ? width : width / 2 - 4;
  Picture part{{to - from, picture.size.height}, {}};
  for (int y = 0; y < picture.size.height; ++y)
    for (int x = from; x < to; ++x) part.pixels.push_back(picture.at({x, y}));
  return part;
}

TEST_F(DemoPictures, AHeatViewIsInMagmaAndBrightWhereModesDiffer) {
  configure({{"arrangement", "flip"}, {"shown", "blend"}, {"compared", {"off"}}});
  DemoRun run = started();
  const auto count = [](const Picture& picture, auto holds) {
    int pixels = 0;
    for (int y = 40; y < picture.size.height - 40; ++y) // between what is written
      for (int x = 0; x < picture.size.width; ++x) pixels += holds(picture.at({x, y}));
    return pixels;
  };
  const auto bright = [](const auto& rgb) { return rgb[0] > 150; };
  const auto unlike_magma = [](const auto& rgb) { return rgb[1] > std::max(rgb[0], rgb[2]) + 1; };
  EXPECT_TRUE(comes_true([&] { return count(run.window().picture(), bright) > 300; }));
  EXPECT_EQ(count(later_picture(run), unlike_magma), 0);
  EXPECT_TRUE(has_label(later_picture(run), 0, 160));
  expect_left_in_silence(run);
}

TEST_F(DemoPictures, ASplitShowsBothHalvesAndTheirNames) {
  DemoRun run = started();
  const Picture single = later_picture(run);
  EXPECT_FALSE(has_label(single, 0, 100) || has_label(single, 220, 320));
  EXPECT_EQ(run.press("b", "comparison")["state"]["arrangement"], "split");
  // the first frame of two modes makes what the second one needs
  EXPECT_TRUE(comes_true([&] { return has_label(run.window().picture(), 220, 320); }));
  const Picture split = later_picture(run);
  EXPECT_TRUE(has_label(split, 0, 100));
  EXPECT_TRUE(has_label(split, 220, 320));
  EXPECT_EQ(difference(half(split, false), half(single, false)), 0);
  EXPECT_GT(difference(half(split, true), half(single, true)), 0.003);
  run.window().drag({160, 90}, {240, 90}, Milliseconds(100));
  EXPECT_NEAR(run.press("b", "comparison")["state"]["split"], 0.75, 0.01);
  EXPECT_TRUE(comes_back(run, single));
  expect_left_in_silence(run);
}

TEST_F(DemoPictures, TheComparedModeIsSeenWhileAKeyIsHeld) {
  DemoRun run = started();
  const Picture shown = later_picture(run);
  run.window().hold("k");
  EXPECT_EQ(run.expect_event("flicker")["message"], "flicker: blend");
  EXPECT_TRUE(comes_to_differ(run, shown, 0.005));
  run.window().let_go("k");
  EXPECT_TRUE(comes_back(run, shown));
  expect_left_in_silence(run);
}

TEST_F(DemoPictures, TheRigsCameraComesBackWithHome) {
  DemoRun run = started();
  const Picture before = later_picture(run);
  EXPECT_EQ(run.press("Home", "camera")["message"], "camera: it is where the rig has it");
  run.window().drag({100, 90}, {200, 100}, Milliseconds(100));
  EXPECT_TRUE(comes_to_differ(run, before, 0.1));
  EXPECT_EQ(run.press("Home", "camera")["message"], "camera: the rig's");
  EXPECT_TRUE(comes_back(run, before));
  run.window().scroll(3);
  EXPECT_TRUE(comes_to_differ(run, before, 0.1));
  expect_left_in_silence(run);
}

TEST_F(DemoPictures, NothingButThePictureIsLeft) {
  configure({{"rig", "still"}, {"shown", "off"}, {"panel", true}});
  DemoRun run = started({640, 360});
  run.press("h", "keys");
  const Picture all = later_picture(run);
  run.press("u", "only the picture");
  const Picture alone = later_picture(run);
  EXPECT_GT(difference(alone, all), 0.3);
  run.press("h", "keys"); // of which nothing is seen
  EXPECT_EQ(difference(later_picture(run), alone), 0);
  run.press("h", "keys");
  run.press("u", "only the picture");
  EXPECT_TRUE(comes_true([&] { return difference(run.window().picture(), alone) > 0.3; }));
  expect_left_in_silence(run);
}

TEST_F(DemoScreenshot, ItIsDrawnAgainByCaptureFromItsSettings) {
  DemoRun run = started();
  run.press("3", "mode");
  run.press("space", "sharpening");
  run.window().press("F12");
  EXPECT_EQ(run.expect_event("unghost-1.png")["event"], "screenshot");
  run.window().press("F12");
  EXPECT_EQ(run.expect_event("unghost-2.png")["message"], "unghost-2.png");
  expect_left_in_silence(run);
  for (const char* name : {"unghost-1.png", "unghost-2.png"}) {
    Process again({"env", "-C", folder.path.string(), program(), "capture", "--settings", name, "--output",
                   "again.png", "--quiet"},
                  desk->talk());
    again.rest();
    EXPECT_EQ(again.exit_code(), 0) << again.talk();
    EXPECT_TRUE(std::filesystem::exists(folder.path / "again.png"));
    std::filesystem::remove(folder.path / "again.png");
  }
}

TEST_F(DemoScreenshot, OneOfASplitIsAComparison) {
  DemoRun run = started();
  run.press("b", "comparison");
  run.window().press("F12");
  run.expect_event("unghost-1.png");
  expect_left_in_silence(run);
  Process again({"env", "-C", folder.path.string(), program(), "compare", "--settings", "unghost-1.png",
                 "--output", "again.png", "--frames", "2"},
                desk->talk());
  again.rest();
  EXPECT_EQ(again.exit_code(), 0) << again.talk();
}

/// Whether both halves of its width and of its height show something.
bool is_drawn(const Picture& picture) {
  const auto varies = [&](Spot from, Spot to) {
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x)
        if (picture.at({x, y}) != picture.at(from)) return true;
    return false;
  };
  const auto [width, height] = picture.size;
  return varies({0, 0}, {width / 2, height / 2}) && varies({width / 2, 0}, {width, height / 2}) &&
         varies({0, height / 2}, {width / 2, height}) && varies({width / 2, height / 2}, {width, height});
}

TEST_F(DemoWindow, ItDrawsOnInEverySize) {
  DemoRun run = started();
  uint64_t drawn = 0;
  for (const Size size : {Size{639, 357}, {161, 91}, {200, 300}, {1, 1}, small}) {
    run.window().resize(size);
    run.window().expect_size(size);
    if (size.width > 1) {
      EXPECT_TRUE(comes_true([&] { return is_drawn(run.window().picture()); }));
    }
    const uint64_t now = run.press("Tab", "movement")["drawn"];
    EXPECT_GT(now, drawn) << size.width;
    drawn = now;
  }
  expect_left_in_silence(run);
}

TEST_F(DemoWindow, APausedPictureFillsEverySize) {
  DemoRun run = started();
  const uint64_t drawn = run.press("p", "pause")["drawn"];
  for (const Size size : {Size{600, 400}, {161, 91}, small}) {
    run.window().resize(size);
    run.window().expect_size(size);
    EXPECT_TRUE(comes_true([&] { return is_drawn(run.window().picture()); })) << size.width;
  }
  EXPECT_EQ(run.press("p", "pause")["drawn"], drawn);
  expect_left_in_silence(run);
}

TEST_F(DemoWindow, AMinimisedOneComesBack) {
  DemoRun run = started();
  const Picture before = later_picture(run);
  for (int i = 0; i < 3; ++i) {
    const uint64_t drawn = run.press("Tab", "movement")["drawn"];
    run.window().minimise();
    std::this_thread::sleep_for(Milliseconds(200));
    if (i == 1) run.window().resize({330, 190});
    if (i == 2) run.window().resize(small);
    run.window().restore();
    if (i != 1) {
      EXPECT_TRUE(comes_back(run, before));
    }
    let_frames_pass(run);
    EXPECT_GT(run.press("Tab", "movement")["drawn"], drawn);
  }
  expect_left_in_silence(run);
}

TEST_F(DemoWindow, ItFillsTheScreenAndIsAWindowAgain) {
  DemoRun run = started();
  for (int i = 0; i < 2; ++i) {
    run.press("F11", "full screen");
    run.window().expect_size({640, 480});
    EXPECT_TRUE(comes_true([&] { return is_drawn(run.window().picture()); }));
    run.press("F11", "full screen");
    run.window().expect_size(small);
    EXPECT_TRUE(comes_true([&] { return is_drawn(run.window().picture()); }));
  }
  expect_left_in_silence(run);
}

} // namespace
} // namespace unghost
