#include "app/demo/actions.h"

#include <set>

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/app/pressed.h"

namespace unghost {
namespace {

/// A row of the GDK sample's table of controls, and what it is to change in `start()`.
struct Control {
  const char *keyboard, *gamepad; // as the table spells them
  int key, button;
  void (*change)(DemoState&);
};

DemoState start() {
  DemoState state = showing("grand-tour");
  shown(state).taa.jitter_scale = 0.5f; // which leaves room both ways
  return state;
}

const Control controls_of_gdk_sample[] = {
    {"Enter", "A", GLFW_KEY_ENTER, GLFW_GAMEPAD_BUTTON_A,
     [](DemoState& s) { s.mode = place_of_mode(s, "off"); }},
    {"Z", "B", GLFW_KEY_Z, GLFW_GAMEPAD_BUTTON_B,
     [](DemoState& s) { shown(s).taa.policy.dilation = Dilation::depth_edges; }},
    {"X", "X", GLFW_KEY_X, GLFW_GAMEPAD_BUTTON_X,
     [](DemoState& s) { shown(s).taa.policy.rectify = Rectify::box_clip; }},
    {"C", "Y", GLFW_KEY_C, GLFW_GAMEPAD_BUTTON_Y,
     [](DemoState& s) { shown(s).taa.policy.jitter = Jitter::halton_16; }},
    {"R", "DPad right", GLFW_KEY_R, GLFW_GAMEPAD_BUTTON_DPAD_RIGHT,
     [](DemoState& s) { shown(s).taa.policy.history = HistoryFilter::catmull_rom_16; }},
    {"F", "DPad left", GLFW_KEY_F, GLFW_GAMEPAD_BUTTON_DPAD_LEFT,
     [](DemoState& s) { shown(s).taa.policy.history = HistoryFilter::bilinear; }},
    {"Space", "Start", GLFW_KEY_SPACE, GLFW_GAMEPAD_BUTTON_START,
     [](DemoState& s) { shown(s).taa.sharpen = 0.5f; }},
    {"T", "DPad up", GLFW_KEY_T, GLFW_GAMEPAD_BUTTON_DPAD_UP,
     [](DemoState& s) { shown(s).taa.jitter_scale = 0.6f; }},
    {"G", "DPad down", GLFW_KEY_G, GLFW_GAMEPAD_BUTTON_DPAD_DOWN,
     [](DemoState& s) { shown(s).taa.jitter_scale = 0.4f; }},
    {"Tab", "RB", GLFW_KEY_TAB, GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, [](DemoState& s) { s.moving = false; }},
    {"V", "LB", GLFW_KEY_V, GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, [](DemoState& s) { s.magnifier.shown = true; }},
    {"Esc", "View", GLFW_KEY_ESCAPE, GLFW_GAMEPAD_BUTTON_BACK, [](DemoState& s) { s.requests.leave = true; }},
};

TEST(DemoActions, TheSamplesKeysAndButtonsChangeWhatTheySayAndNothingElse) {
  for (const Control& control : controls_of_gdk_sample) {
    DemoState expected = start();
    control.change(expected);
    const Action* by_key = action_for_key(control.key, false);
    ASSERT_NE(by_key, nullptr) << control.keyboard;
    EXPECT_EQ(by_key, action_for_button(control.button)) << control.gamepad;
    EXPECT_EQ(key_text(*by_key), control.keyboard);
    EXPECT_EQ(button_text(*by_key), control.gamepad);
    DemoState state = start();
    perform(*by_key, state);
    EXPECT_TRUE(without_message(state) == expected) << control.keyboard << ": " << state.message;
    EXPECT_NE(state.message, "") << control.keyboard;
  }
}

TEST(DemoActions, NoOtherActionHasAButton) {
  size_t buttons = 0;
  for (const Action& action : actions()) buttons += action.button != no_button;
  EXPECT_EQ(buttons, std::size(controls_of_gdk_sample));
  EXPECT_EQ(action_for_button(no_button), nullptr);
  EXPECT_EQ(action_for_button(GLFW_GAMEPAD_BUTTON_GUIDE), nullptr);
}

TEST(DemoActions, EveryKeyAndButtonStandsOnceAndIsFound) {
  std::set<std::string> keys;
  std::set<std::string_view> buttons;
  for (const Action& action : actions()) {
    EXPECT_TRUE(keys.insert(key_text(action)).second) << key_text(action);
    EXPECT_EQ(action_for_key(action.key, action.shift), &action) << key_text(action);
    EXPECT_FALSE(action.name.empty());
    EXPECT_FALSE(action.what.empty()) << action.name;
    for (const char c : key_text(action)) EXPECT_TRUE(c >= ' ' && c <= '~') << action.name;
    if (action.button == no_button) continue;
    EXPECT_TRUE(buttons.insert(button_text(action)).second) << button_text(action);
    EXPECT_EQ(action_for_button(action.button), &action);
  }
  EXPECT_EQ(action_for_key(GLFW_KEY_F5, false), nullptr);
}

TEST(DemoActions, ShiftIsReadOnlyWhereItMeansSomething) {
  EXPECT_EQ(action_for_key(GLFW_KEY_X, true), action_for_key(GLFW_KEY_X, false));
  EXPECT_NE(action_for_key(GLFW_KEY_N, true), action_for_key(GLFW_KEY_N, false));
  EXPECT_EQ(key_text(*action_for_key(GLFW_KEY_N, true)), "Shift+N");
}

TEST(DemoActions, WhatHasNoEffectSaysWhyAndChangesNothing) {
  for (const TaaMode& row : taa_modes())
    for (const Action& action : actions()) {
      DemoState state = showing(row.name);
      const DemoState before = state;
      const std::string why_not = action.why_not(state);
      perform(action, state);
      const bool already = action.what == "Show " + before.modes[before.mode].name;
      const bool while_held = action.name == "flicker"; // which the window's loop looks at
      EXPECT_EQ(without_message(state) == before, !why_not.empty() || already || while_held)
          << row.name << ": " << action.what << ": " << state.message;
      EXPECT_TRUE(state.message.starts_with(action.name)) << state.message;
      if (!why_not.empty()) {
        EXPECT_EQ(state.message, std::string(action.name) + ": " + why_not);
      }
    }
}

TEST(DemoActions, ReasonsAreThoseOfTheSettingsTable) {
  DemoState off = showing("off");
  const std::pair<int, std::string> reasons[] = {
      {GLFW_KEY_Z, "dilation: blend=current keeps no history"},
      {GLFW_KEY_X, "rectification: blend=current keeps no history"},
      {GLFW_KEY_R, "history filter: blend=current keeps no history"},
      {GLFW_KEY_F, "history filter: blend=current keeps no history"},
      {GLFW_KEY_G, "jitter scale: jitter=none does not move the samples"},
      {GLFW_KEY_BACKSPACE, "history: off keeps none"},
      {GLFW_KEY_PERIOD, "one frame: nothing is paused"}};
  for (const auto& [key, reason] : reasons) {
    press(off, key);
    EXPECT_EQ(off.message, reason);
  }
  DemoState resting = default_demo_state();
  resting.rig = "still";
  press(resting, GLFW_KEY_TAB);
  EXPECT_EQ(resting.message, "movement: nothing moves in the rig 'still'");
  EXPECT_TRUE(resting.moving);
}

TEST(DemoActions, MessagesSayWhatItCameTo) {
  DemoState state = showing("grand-tour");
  const std::pair<int, std::string> messages[] = {{GLFW_KEY_X, "rectification: box-clip"},
                                                  {GLFW_KEY_R, "history filter: catmull-rom-16"},
                                                  {GLFW_KEY_SPACE, "sharpening: 0.5"},
                                                  {GLFW_KEY_SPACE, "sharpening: off"},
                                                  {GLFW_KEY_G, "jitter scale: 0.9"},
                                                  {GLFW_KEY_V, "magnifier: on"},
                                                  {GLFW_KEY_V, "magnifier: off"},
                                                  {GLFW_KEY_B, "comparison: split with blend"},
                                                  {GLFW_KEY_B, "comparison: off"},
                                                  {GLFW_KEY_ENTER, "TAA: off"},
                                                  {GLFW_KEY_ENTER, "TAA: on, grand-tour"},
                                                  {GLFW_KEY_1, "mode: blend"},
                                                  {GLFW_KEY_N, "view: albedo"},
                                                  {GLFW_KEY_BACKSPACE, "history: dropped"},
                                                  {GLFW_KEY_F12, "screenshot"}};
  for (const auto& [key, message] : messages) {
    press(state, key);
    EXPECT_EQ(state.message, message);
  }
}

TEST(DemoActions, AColumnIsGoneThroughOnceRoundAndBackAgain) {
  const std::pair<int, const char*> columns[] = {
      {GLFW_KEY_Z, "dilation"}, {GLFW_KEY_X, "rectify"}, {GLFW_KEY_C, "jitter"}, {GLFW_KEY_R, "history"}};
  for (const TaaMode& mode : taa_modes())
    for (const auto& [key, column] : columns) {
      DemoState state = showing(mode.name);
      if (!action_for_key(key, false)->why_not(state).empty()) continue;
      const Setting& row = find_setting(column);
      const DemoState before = state;
      std::set<std::string> seen;
      do {
        press(state, key);
        const Settings settings = settings_of(state, state.mode);
        EXPECT_FALSE(refusal(settings)) << mode.name << " " << row.get(settings);
        EXPECT_TRUE(seen.insert(row.get(settings)).second) << mode.name << " " << row.get(settings);
      } while (without_message(state) != before && seen.size() <= row.answers.size());
      EXPECT_EQ(seen.size(), row.answers.size()) << mode.name << " " << column;
    }
}

TEST(DemoActions, BackIsTheOtherWay) {
  DemoState state = showing("grand-tour");
  const DemoState before = state;
  for (const auto& [there, back, shift] : {std::tuple{GLFW_KEY_R, GLFW_KEY_F, false},
                                           {GLFW_KEY_F, GLFW_KEY_R, false},
                                           {GLFW_KEY_N, GLFW_KEY_N, true},
                                           {GLFW_KEY_RIGHT_BRACKET, GLFW_KEY_LEFT_BRACKET, false}}) {
    press(state, there);
    EXPECT_FALSE(without_message(state) == before);
    press(state, back, shift);
    EXPECT_EQ(state.mode, before.mode);
    EXPECT_TRUE(state.modes == before.modes && state.settings == before.settings) << there;
  }
}

TEST(DemoActions, AnAnswerThatIsRefusedIsPassedOver) {
  DemoState state = showing("grand-tour");
  shown(state).taa.policy.blend = Blend::attenuated; // which rectify=none leaves nothing to act upon
  std::set<Rectify> seen;
  for (size_t i = 0; i < 2 * answers<Rectify>().size(); ++i) {
    press(state, GLFW_KEY_X);
    seen.insert(shown(state).taa.policy.rectify);
  }
  EXPECT_EQ(seen.size(), answers<Rectify>().size() - 1);
  EXPECT_FALSE(seen.contains(Rectify::none));
}

TEST(DemoActions, JitterScaleGoesInTenths) {
  DemoState state = showing("grand-tour");
  press(state, GLFW_KEY_T);
  EXPECT_EQ(state.message, "jitter scale: 1 is the most");
  for (const float scale : {0.9f, 0.8f, 0.7f, 0.6f, 0.5f, 0.4f, 0.3f, 0.2f}) {
    press(state, GLFW_KEY_G);
    EXPECT_EQ(shown(state).taa.jitter_scale, scale);
  }
  press(state, GLFW_KEY_G);
  EXPECT_EQ(state.message, "jitter scale: 0.2 is the least");
  for (int i = 0; i < 8; ++i) press(state, GLFW_KEY_T);
  EXPECT_EQ(shown(state).taa.jitter_scale, 1);
  shown(state).taa.jitter_scale = 0.01f; // as the panel can set it
  press(state, GLFW_KEY_T);
  EXPECT_EQ(shown(state).taa.jitter_scale, 0.2f);
}

TEST(DemoActions, SharpeningGoesOffFromAnyAmount) {
  DemoState state = default_demo_state();
  shown(state).taa.sharpen = 2;
  press(state, GLFW_KEY_SPACE);
  EXPECT_EQ(shown(state).taa.sharpen, 0);
  press(state, GLFW_KEY_SPACE);
  EXPECT_EQ(shown(state).taa.sharpen, 0.5f);
}

TEST(DemoActions, TheRestChangesOnePlaceEach) {
  const std::pair<int, void (*)(DemoState&)> rest[] = {
      {GLFW_KEY_N, [](DemoState& s) { s.settings.view = View::albedo; }},
      {GLFW_KEY_P, [](DemoState& s) { s.paused = true; }},
      {GLFW_KEY_BACKSPACE, [](DemoState& s) { s.requests.drop_history = true; }},
      {GLFW_KEY_F11, [](DemoState& s) { s.requests.full_screen = true; }},
      {GLFW_KEY_F12, [](DemoState& s) { s.requests.screenshot = true; }},
      {GLFW_KEY_H, [](DemoState& s) { s.keys = true; }},
      {GLFW_KEY_U, [](DemoState& s) { s.hidden = true; }},
      {GLFW_KEY_B, [](DemoState& s) { s.arrangement = Arrangement::split; }},
      {GLFW_KEY_L, [](DemoState& s) { s.rig = "rotate"; }},
  };
  for (const auto& [key, change] : rest) {
    DemoState state = default_demo_state(), expected = state;
    press(state, key);
    change(expected);
    EXPECT_TRUE(without_message(state) == expected) << state.message;
  }
}

TEST(DemoActions, ArrangementsOfSeveralModesAreGoneThrough) {
  DemoState state = default_demo_state();
  std::set<Arrangement> seen;
  for (size_t i = 0; i + 1 < answers<Arrangement>().size(); ++i) {
    press(state, GLFW_KEY_B, true);
    EXPECT_TRUE(seen.insert(state.arrangement).second) << state.message;
  }
  EXPECT_FALSE(seen.contains(Arrangement::single));
  press(state, GLFW_KEY_B, true);
  EXPECT_TRUE(seen.contains(state.arrangement)) << "once round";
  press(state, GLFW_KEY_B);
  EXPECT_EQ(state.arrangement, Arrangement::single);
}

TEST(DemoActions, AGridGrowsToFourAndShrinksToTwo) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_EQUAL);
  EXPECT_EQ(state.message, "compared: nothing is compared");
  press(state, GLFW_KEY_B);
  press(state, GLFW_KEY_MINUS);
  EXPECT_EQ(state.message, "compared: two are the least");
  for (const size_t count : {3, 4, 4}) {
    press(state, GLFW_KEY_EQUAL);
    EXPECT_EQ(modes_seen(state).size(), count);
    EXPECT_EQ(state.arrangement, Arrangement::grid);
  }
  EXPECT_EQ(state.message, "compared: four are the most");
  for (const size_t count : {3, 2, 2}) {
    press(state, GLFW_KEY_MINUS);
    EXPECT_EQ(modes_seen(state).size(), count);
  }
}

TEST(DemoActions, AModeAndEverythingCanBeReset) {
  DemoState state = showing("blend");
  const DemoState before = state;
  press(state, GLFW_KEY_DELETE);
  EXPECT_EQ(state.message, "settings: it is as its row has it");
  press(state, GLFW_KEY_Z);
  press(state, GLFW_KEY_N);
  press(state, GLFW_KEY_DELETE);
  EXPECT_TRUE(state.modes == before.modes);
  EXPECT_EQ(state.settings.view, View::albedo) << "which belongs to no mode";
  state.scene = "/another.glb";
  press(state, GLFW_KEY_Z);
  press(state, GLFW_KEY_DELETE, true);
  DemoState expected = default_demo_state();
  expected.scene = "/another.glb";
  EXPECT_TRUE(without_message(state) == expected);
  press(state, GLFW_KEY_DELETE, true);
  EXPECT_EQ(state.message, "everything: it is");
}

TEST(DemoActions, TheComparedModeIsHeldUpOnlyWhereItIsNotSeenAlready) {
  DemoState state = default_demo_state();
  const DemoState before = state;
  press(state, GLFW_KEY_K);
  EXPECT_EQ(state.message, "flicker: blend");
  EXPECT_TRUE(without_message(state) == before);
  press(state, GLFW_KEY_B);
  press(state, GLFW_KEY_K);
  EXPECT_EQ(state.message, "flicker: they are all shown");
}

TEST(DemoActions, TheRigsCameraComesBack) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_HOME);
  EXPECT_EQ(state.message, "camera: it is where the rig has it");
  state.camera.yaw = 1;
  EXPECT_EQ(action_for_key(GLFW_KEY_HOME, false)->present(state), "moved");
  press(state, GLFW_KEY_HOME);
  EXPECT_EQ(state.message, "camera: the rig's");
  EXPECT_TRUE(state.camera == CameraOffset{});
}

TEST(DemoActions, TheMagnifierFollowsOnlyWhereItIsShown) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_V, true);
  EXPECT_EQ(state.message, "magnifier at the mouse: it is not shown");
  EXPECT_FALSE(state.magnifier_follows || state.magnifier.shown);
  press(state, GLFW_KEY_V);
  press(state, GLFW_KEY_V, true);
  EXPECT_TRUE(state.magnifier_follows && state.magnifier.shown);
}

TEST(DemoActions, APickedPixelIsForgotten) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_I);
  EXPECT_EQ(state.message, "pixel: none is picked: click on one");
  state.picked = {.mode = 0, .at = {0.5, 0.25}};
  EXPECT_EQ(pixel_of(*state.picked, {10, 8}), glm::ivec2(5, 2));
  EXPECT_EQ(pixel_of({.at = {1, 1}}, {10, 8}), glm::ivec2(9, 7)) << "the edge is the last one's";
  press(state, GLFW_KEY_I);
  EXPECT_FALSE(state.picked);
}

TEST(DemoActions, OneFrameIsForWhatIsPaused) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_PERIOD);
  EXPECT_FALSE(state.requests.step);
  press(state, GLFW_KEY_P);
  press(state, GLFW_KEY_PERIOD);
  EXPECT_TRUE(state.requests.step);
  EXPECT_TRUE(state.paused);
}

TEST(DemoActions, ViewsAreGoneThroughOnce) {
  DemoState state = default_demo_state();
  std::set<View> seen;
  for (size_t i = 0; i < answers<View>().size(); ++i, press(state, GLFW_KEY_N))
    seen.insert(state.settings.view);
  EXPECT_EQ(seen.size(), answers<View>().size());
  EXPECT_EQ(state.settings.view, View::colour);
  press(state, GLFW_KEY_N, true);
  EXPECT_EQ(uint32_t(state.settings.view), answers<View>().back().value);
}

} // namespace
} // namespace unghost
