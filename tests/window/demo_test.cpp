// Keys and gamepads of the real demo: what each changes, as the program tells it, and as the window shows it.
#include "tests/window/driven_demo.h"

#include <csignal>

#include <GLFW/glfw3.h>

namespace unghost {
namespace {

using nlohmann::json;

/// A row of the GDK sample's table of controls: what it does to a state in which the rows before it have done
/// theirs.
struct Control {
  const char* key;
  int button;
  const char* action;
  json change;         // a merge patch of the state (RFC 7396)
  const char* message; // what is not kept is only said
};

json own(const json& change) { return {{"modes", {{"grand-tour", change}}}}; }

const std::vector<Control>& controls_of_gdk_sample() {
  static const std::vector<Control> rows = {
      {"Return", GLFW_GAMEPAD_BUTTON_A, "TAA", {{"shown", "off"}}, "TAA: off"},
      {"Return", GLFW_GAMEPAD_BUTTON_A, "TAA", {{"shown", "grand-tour"}}, "TAA: on, grand-tour"},
      {"z", GLFW_GAMEPAD_BUTTON_B, "dilation", own({{"dilation", "depth-edges"}}), "dilation: depth-edges"},
      {"x", GLFW_GAMEPAD_BUTTON_X, "rectification", own({{"rectify", "box-clip"}}),
       "rectification: box-clip"},
      {"c", GLFW_GAMEPAD_BUTTON_Y, "jitter", own({{"jitter", "halton-16"}}), "jitter: halton-16"},
      {"r", GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, "history filter", own({{"history", "catmull-rom-16"}}),
       "history filter: catmull-rom-16"},
      {"f", GLFW_GAMEPAD_BUTTON_DPAD_LEFT, "history filter", own({{"history", nullptr}}),
       "history filter: catmull-rom"},
      {"space", GLFW_GAMEPAD_BUTTON_START, "sharpening", own({{"sharpen", 0.5}}), "sharpening: 0.5"},
      {"t", GLFW_GAMEPAD_BUTTON_DPAD_UP, "jitter scale", own({{"jitter-scale", 0.6}}), "jitter scale: 0.6"},
      {"g", GLFW_GAMEPAD_BUTTON_DPAD_DOWN, "jitter scale", own({{"jitter-scale", 0.5}}), "jitter scale: 0.5"},
      {"Tab", GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, "movement", json::object(), "movement: off"},
      {"v", GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, "magnifier", {{"magnifier", true}}, "magnifier: on"},
  };
  return rows;
}

class DemoControls : public DrivenDemo {
protected:
  void SetUp() override {
    DrivenDemo::SetUp();
    json state = own({{"jitter-scale", 0.5}}); // which leaves room both ways
    state["shown"] = "grand-tour";
    if (desk) configure(state);
  }

  /// `press`: does a row, and returns what the program says to it.
  static void expect_changes(json state, const std::function<json(const Control&)>& press) {
    for (const Control& row : controls_of_gdk_sample()) {
      state.merge_patch(row.change);
      const json event = press(row);
      EXPECT_EQ(event["message"], row.message);
      EXPECT_EQ(event["state"], state) << row.message;
    }
  }
};

class DemoKeys : public DemoControls {};
class DemoPad : public DemoControls {};

TEST_F(DemoKeys, TheSamplesControlsChangeWhatTheySayAndNothingElse) {
  DemoRun run = started();
  expect_changes(run.ready()["state"], [&](const Control& row) { return run.press(row.key, row.action); });
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, WhatEachOfThemDidIsReadInTheWindow) {
  DemoRun run = started();
  run.press("p", "pause"); // so that nothing else changes
  const auto silent = lowest_lines(silent_picture(run));
  const auto is_silent = [&] { return lowest_lines(run.window().picture()) == silent; };
  for (const Control& row : controls_of_gdk_sample()) {
    EXPECT_TRUE(comes_true(is_silent)) << "before " << row.message;
    EXPECT_EQ(run.press(row.key, row.action)["message"], row.message);
    EXPECT_TRUE(comes_true([&] { return !is_silent(); })) << row.message;
  }
  expect_left_in_silence(run);
}

TEST_F(DemoPad, TheSamplesControlsDoTheSameOnOneThatIsPluggedInLater) {
  DemoRun run = started();
  Pad pad(*desk);
  pad.plug();
  EXPECT_EQ(run.next_event(patience).value_or(json())["event"], "gamepad");
  expect_changes(run.ready()["state"],
                 [&](const Control& row) { return run.press(pad, row.button, row.action); });
  pad.press(GLFW_GAMEPAD_BUTTON_BACK);
  EXPECT_EQ(run.ended(), 0);
  EXPECT_EQ(run.talk(), "");
}

TEST_F(DemoPad, OneIsUnpluggedAndPluggedInAgain) {
  Pad pad(*desk);
  pad.plug();
  DemoRun run = started();
  for (const char* shown : {"off", "grand-tour", "off"}) {
    EXPECT_EQ(run.press(pad, GLFW_GAMEPAD_BUTTON_A, "TAA")["state"]["shown"], shown);
    pad.unplug();
    const std::string gone = run.next_event(patience).value_or(json()).value("message", "");
    EXPECT_TRUE(gone.ends_with(" is gone")) << gone;
    pad.plug();
    const std::string back = run.next_event(patience).value_or(json()).value("message", "");
    EXPECT_TRUE(back.ends_with(" is connected")) << back;
  }
  pad.unplug();
  expect_left_in_silence(run);
}

TEST_F(DemoPad, ItsSticksFlyTheCameraAndMoveTheMagnifier) {
  configure({{"rig", "still"}, {"shown", "off"}});
  DemoRun run = started();
  Pad pad(*desk);
  pad.plug();
  const Picture before = later_picture(run);
  pad.axis(GLFW_GAMEPAD_AXIS_LEFT_X, 1);
  EXPECT_TRUE(comes_to_differ(run, before, 0.05));
  pad.axis(GLFW_GAMEPAD_AXIS_LEFT_X, 0);
  run.press(pad, GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, "magnifier");
  pad.axis(GLFW_GAMEPAD_AXIS_RIGHT_X, 1);
  pad.axis(GLFW_GAMEPAD_AXIS_RIGHT_Y, -1);
  EXPECT_TRUE(comes_true([&] {
    const json at = asked(run)["state"]["magnified"];
    return at[0] > 0.55 && at[1] < 0.45;
  }));
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, WhatRestsIsNotDrawnUntilSomethingChanges) {
  configure({{"rig", "still"}, {"shown", "gdk-clamp"}});
  DemoRun run = started();
  const auto rests = [&] { return asked(run)["rests"] == true; };
  EXPECT_TRUE(comes_true(rests));
  const Picture picture = later_picture(run);
  EXPECT_EQ(difference(later_picture(run), picture), 0);
  run.press("n", "view");
  EXPECT_TRUE(comes_to_differ(run, picture, 0.05));
  EXPECT_TRUE(comes_true(rests));
  run.press("l", "rig");
  const Picture moving = later_picture(run);
  EXPECT_TRUE(comes_to_differ(run, moving, 0.01));
  EXPECT_FALSE(rests());
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, DigitsShowTheFirstModesThatBracketsGoThroughAndTheUsualOne) {
  configure({});
  DemoRun run = started();
  const std::string digits = "1234567890";
  Words names;
  for (const char digit : digits) names.push_back(run.press({digit}, "mode")["state"]["shown"]);
  EXPECT_EQ(names.back(), "unghost");
  names.back() = "rgb"; // the next row
  run.press("1", "mode");
  for (size_t i = 1; i < names.size(); ++i)
    EXPECT_EQ(run.press("bracketright", "mode")["state"]["shown"], names[i]);
  for (size_t i = names.size() - 1; i-- > 0;)
    EXPECT_EQ(run.press("bracketleft", "mode")["state"]["shown"], names[i]);
  EXPECT_EQ(names.front(), "blend");
  EXPECT_EQ(run.press("bracketleft", "mode")["state"]["shown"], "off");
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, RigsAreGoneThroughOnceRound) {
  DemoRun run = started();
  const std::string first = run.ready()["state"]["rig"];
  Words seen;
  do seen.push_back(run.press("l", "rig")["state"]["rig"]);
  while (seen.back() != first && seen.size() < 50);
  EXPECT_EQ(seen.back(), first);
  std::ranges::sort(seen);
  EXPECT_EQ(std::ranges::adjacent_find(seen), seen.end());
  EXPECT_GT(seen.size(), 3u);
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, NoFrameIsDrawnWhilePausedButWhatIsAskedFor) {
  DemoRun run = started();
  EXPECT_EQ(run.press("period", "one frame")["message"], "one frame: nothing is paused");
  const uint64_t drawn = run.press("p", "pause")["drawn"];
  let_frames_pass(run);
  for (uint64_t more = 0; more < 3; ++more) {
    EXPECT_EQ(run.press("period", "one frame")["drawn"], drawn + more);
    let_frames_pass(run);
  }
  EXPECT_EQ(run.press("p", "pause")["drawn"], drawn + 3);
  let_frames_pass(run);
  EXPECT_GT(run.press("p", "pause")["drawn"], drawn + 3);
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, TheMagnifierFollowsTheMouse) {
  DemoRun run = started();
  EXPECT_EQ(run.press("shift+v", "magnifier at the mouse")["message"],
            "magnifier at the mouse: it is not shown");
  run.press("v", "magnifier");
  EXPECT_EQ(run.press("shift+v", "magnifier at the mouse")["state"]["magnifier-follows"], true);
  run.window().move_mouse({80, 135});
  EXPECT_TRUE(comes_true([&] {
    const json at = asked(run)["state"]["magnified"];
    return std::abs(double(at[0]) - 0.25) < 0.01 && std::abs(double(at[1]) - 0.75) < 0.01;
  }));
  const json at = run.press("shift+v", "magnifier at the mouse")["state"]["magnified"];
  run.window().move_mouse({10, 10});
  let_frames_pass(run);
  EXPECT_EQ(run.press("v", "magnifier")["state"]["magnified"], at);
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, WhatWasLeftIsThereOnTheNextStart) {
  json left;
  {
    DemoRun run = started();
    run.press("3", "mode");
    run.press("x", "rectification");
    run.press("n", "view");
    run.press("b", "comparison");
    run.press("v", "magnifier");
    left = run.press("l", "rig")["state"];
    expect_left_in_silence(run);
  }
  DemoRun run = started();
  EXPECT_EQ(run.ready()["state"], left);
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, ASignalEndsItAndLosesNoBookmark) {
  for (const int signal : {SIGINT, SIGTERM}) {
    DemoRun run = started();
    const json kept = run.press("m", "bookmark")["state"];
    EXPECT_EQ(run.ended_by(signal), 128 + signal) << run.talk();
    EXPECT_EQ(json::parse(content_of(config_file()))["bookmarks"], kept["bookmarks"]);
    EXPECT_EQ(kept["bookmarks"].size(), signal == SIGINT ? 1u : 2u);
  }
}

TEST_F(DemoKeys, AModeWithASettingOfItsOwnIsItsRowWithThat) {
  DemoRun run = started(small, {"--mode", "blend:alpha=0.25"});
  EXPECT_EQ(run.ready()["state"]["shown"], "blend");
  EXPECT_EQ(run.ready()["state"]["modes"]["blend"]["alpha"], 0.25);
  expect_left_in_silence(run);
}

TEST_F(DemoKeys, AModeThatIsAskedForIsNotComparedWithItselfOnTheNextStart) {
  configure({{"compared", {"blend"}}});
  for (const Words& words : {Words{"--mode", "blend"}, Words{}}) {
    DemoRun run = started(small, words);
    EXPECT_EQ(run.ready()["state"]["shown"], "blend");
    EXPECT_EQ(run.ready()["state"]["compared"], json{"unghost"});
    expect_left_in_silence(run);
  }
}

} // namespace
} // namespace unghost
