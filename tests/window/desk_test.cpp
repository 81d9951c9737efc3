// The harness itself, proved with a program that prints what reaches it.
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/app/own_copy.h"
#include "tests/window/demo_run.h"

namespace unghost {
namespace {

class DeskTest : public testing::Test {
protected:
  void SetUp() override {
    if (const std::string sentence = Desk::missing(); !sentence.empty()) GTEST_SKIP() << sentence;
    desk.emplace(Size{640, 480});
  }

  static Words probe(int frame_ms = 5) {
    return {(folder_of_this_program() / "window_probe").string(), std::to_string(frame_ms)};
  }
  static std::string button(int number, bool down) {
    return "button " + std::to_string(number) + (down ? " down" : " up");
  }
  static std::string key(int number, bool down) {
    return "key " + std::to_string(number) + (down ? " down" : " up");
  }

  static std::string next(DemoRun& run) {
    const auto event = run.next_event(Milliseconds(10'000));
    return event ? event->at("action") : "nothing";
  }

  std::optional<Desk> desk;
};

class DeskGamepad : public DeskTest {};

TEST_F(DeskTest, EveryKeyOfTheControlsArrives) {
  DemoRun run(*desk, probe());
  const std::vector<std::pair<const char*, int>> keys = {
      {"Return", GLFW_KEY_ENTER}, {"z", GLFW_KEY_Z}, {"x", GLFW_KEY_X},    {"c", GLFW_KEY_C},
      {"r", GLFW_KEY_R},          {"f", GLFW_KEY_F}, {"t", GLFW_KEY_T},    {"g", GLFW_KEY_G},
      {"space", GLFW_KEY_SPACE},  {"v", GLFW_KEY_V}, {"Tab", GLFW_KEY_TAB}};
  for (const auto& [name, number] : keys) {
    run.press(name, key(number, true));
    ASSERT_EQ(next(run), key(number, false));
  }
}

TEST_F(DeskTest, AHeldKeyStaysDown) {
  DemoRun run(*desk, probe());
  run.window().hold("w");
  run.expect_event(key(GLFW_KEY_W, true));
  run.window().let_go("w");
  run.expect_event(key(GLFW_KEY_W, false));
}

TEST_F(DeskTest, EscapeEndsTheProgramWhichSaysGoodbye) {
  DemoRun run(*desk, probe());
  EXPECT_EQ(run.leave(), 0);
  EXPECT_EQ(run.talk(), "probe: goodbye\n");
}

TEST_F(DeskTest, TheMouseArrivesWhereItIs) {
  DemoRun run(*desk, probe());
  run.window().click({20, 30});
  const auto down = run.expect_event("mouse 0 down");
  EXPECT_EQ(down["state"], (nlohmann::json{{"x", 20.0}, {"y", 30.0}}));
  run.expect_event("mouse 0 up");
  run.window().click({20, 30}, 3);
  run.expect_event("mouse 1 down"); // GLFW's number of the right one
  run.window().drag({10, 10}, {60, 90});
  EXPECT_EQ(run.expect_event("mouse 0 down")["state"]["x"], 10.0);
  EXPECT_EQ(run.expect_event("mouse 0 up")["state"], (nlohmann::json{{"x", 60.0}, {"y", 90.0}}));
  run.window().scroll(2);
  run.expect_event("scroll up");
  EXPECT_EQ(next(run), "scroll up");
  run.window().scroll(-1);
  EXPECT_EQ(next(run), "scroll down");
}

TEST_F(DeskTest, AResizeArrives) {
  DemoRun run(*desk, probe());
  run.window().resize({320, 200});
  EXPECT_EQ(run.expect_event("resized")["state"], (nlohmann::json{{"width", 320}, {"height", 200}}));
  run.window().expect_size({320, 200});
}

TEST_F(DeskTest, AMinimisedWindowKnowsAndComesBack) {
  DemoRun run(*desk, probe());
  run.window().minimise();
  run.expect_event("minimised");
  run.window().restore();
  run.expect_event("restored");
  run.press("z", key(GLFW_KEY_Z, true));
}

TEST_F(DeskTest, APictureIsOfTheWindowAndNothingElse) {
  DemoRun run(*desk, probe());
  const Picture picture = run.window().picture();
  ASSERT_EQ(picture.size, (Size{200, 120}));
  const std::array<uint8_t, 3> red = {0xff, 0x40, 0x20}, blue = {0x20, 0x40, 0x80};
  for (int y = 0; y < 120; y++)
    for (int x = 0; x < 200; x++)
      ASSERT_EQ(picture.at({x, y}), x % 16 < 8 && y % 16 < 8 ? red : blue) << x << "," << y;
  EXPECT_THROW(desk->picture({600, 0}, {41, 10}), std::runtime_error);
}

TEST_F(DeskTest, APictureIsWrittenForAPerson) {
  const ScratchFolder folder;
  write_ppm({{2, 1}, {{1, 2, 3}, {4, 5, 6}}}, folder.path / "two.ppm");
  EXPECT_EQ(content_of(folder.path / "two.ppm"), "P6\n2 1\n255\n\1\2\3\4\5\6");
}

TEST_F(DeskTest, TwoDesksStandSideBySide) {
  const Desk other({320, 240});
  EXPECT_NE(desk->display(), other.display());
  DemoRun here(*desk, probe()), there(other, probe());
  here.press("z", key(GLFW_KEY_Z, true));
  EXPECT_EQ(next(here), key(GLFW_KEY_Z, false));
  EXPECT_FALSE(there.next_event(Milliseconds(200)));
}

TEST_F(DeskTest, RunsOnOneDeskShareAHome) {
  const std::string home = desk->home().string();
  for (int i = 0; i < 2; i++) {
    DemoRun run(*desk, probe());
    EXPECT_EQ(run.ready()["state"]["config"], home + "/config");
    EXPECT_EQ(run.leave(), 0);
  }
}

TEST_F(DeskTest, WhatDoesNotStartIsSaidWithItsReason) {
  try {
    DemoRun run(*desk, {"ls", "/nowhere"});
    FAIL() << "it was ready";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot access '/nowhere'"), std::string::npos) << error.what();
  }
}

TEST_F(DeskTest, AProgramGoesWithItsRun) {
  pid_t child = 0;
  {
    DemoRun run(*desk, probe());
    child = run.ready()["state"]["pid"];
    EXPECT_EQ(kill(child, 0), 0);
  }
  EXPECT_NE(kill(child, 0), 0);
}

TEST_F(DeskGamepad, OneThatIsThereIsFound) {
  Pad pad(*desk);
  EXPECT_EQ(DemoRun(*desk, probe()).ready()["state"]["gamepad"], false);
  pad.plug();
  EXPECT_EQ(DemoRun(*desk, probe()).ready()["state"]["gamepad"], true);
}

TEST_F(DeskGamepad, OneIsPluggedInAndUnpluggedWhileTheProgramRuns) {
  Pad pad(*desk);
  DemoRun run(*desk, probe());
  for (int i = 0; i < 2; i++) {
    pad.plug();
    const auto plugged = run.expect_event("plugged");
    EXPECT_EQ(plugged["state"]["name"], "Microsoft X-Box 360 pad"); // as GLFW's table has it
    EXPECT_EQ(plugged["state"]["guid"], "030000005e0400008e02000004010000");
    run.press(pad, GLFW_GAMEPAD_BUTTON_A, button(GLFW_GAMEPAD_BUTTON_A, true));
    run.expect_event(button(GLFW_GAMEPAD_BUTTON_A, false));
    pad.unplug();
    run.expect_event("unplugged");
  }
}

TEST_F(DeskGamepad, EveryButtonArrivesAsItself) {
  Pad pad(*desk);
  pad.plug();
  DemoRun run(*desk, probe());
  for (int number = 0; number <= GLFW_GAMEPAD_BUTTON_LAST; number++) {
    pad.press(number);
    ASSERT_EQ(next(run), button(number, true));
    ASSERT_EQ(next(run), button(number, false));
  }
}

TEST_F(DeskGamepad, NoPressIsLostOnASlowProgram) {
  Pad pad(*desk);
  pad.plug();
  DemoRun run(*desk, probe(100));
  for (int i = 0; i < 3; i++) pad.press(GLFW_GAMEPAD_BUTTON_B);
  for (int i = 0; i < 6; i++) ASSERT_EQ(next(run), button(GLFW_GAMEPAD_BUTTON_B, i % 2 == 0));
}

TEST_F(DeskGamepad, AxesArriveAtBothEndsAndBetween) {
  Pad pad(*desk);
  pad.plug();
  DemoRun run(*desk, probe());
  for (int axis = 0; axis <= GLFW_GAMEPAD_AXIS_LAST; axis++)
    for (const float value : {0.5f, 1.f, -1.f}) {
      pad.axis(axis, value);
      const auto event = run.expect_event("axis " + std::to_string(axis));
      EXPECT_NEAR(event["state"]["value"].get<float>(), value, 0.005f); // a trigger has 256 steps
    }
}

TEST_F(DeskGamepad, TheSecondOneStaysWhenTheFirstGoes) {
  Pad first(*desk, 0), second(*desk, 1);
  first.plug();
  second.plug();
  DemoRun run(*desk, probe());
  first.unplug();
  run.expect_event("unplugged");
  run.press(second, GLFW_GAMEPAD_BUTTON_Y, button(GLFW_GAMEPAD_BUTTON_Y, true));
}

} // namespace
} // namespace unghost
