#include "app/demo/actions.h"

#include <set>

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/app/pressed.h"

namespace unghost {
namespace {

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

} // namespace
} // namespace unghost
