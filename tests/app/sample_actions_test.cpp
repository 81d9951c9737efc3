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
     [](DemoState& s) { s.shown_before = s.mode, s.mode = place_of_mode(s, "off"); }},
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

TEST(SampleActions, TheSamplesKeysAndButtonsChangeWhatTheySayAndNothingElse) {
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

TEST(SampleActions, NoOtherActionHasAButton) {
  size_t buttons = 0;
  for (const Action& action : actions()) buttons += action.button != no_button;
  EXPECT_EQ(buttons, std::size(controls_of_gdk_sample));
  EXPECT_EQ(action_for_button(no_button), nullptr);
  EXPECT_EQ(action_for_button(GLFW_GAMEPAD_BUTTON_GUIDE), nullptr);
}

TEST(SampleActions, AColumnIsGoneThroughOnceRoundAndBackAgain) {
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

TEST(SampleActions, BackIsTheOtherWay) {
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

TEST(SampleActions, AnAnswerThatIsRefusedIsPassedOver) {
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

TEST(SampleActions, JitterScaleGoesInTenths) {
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

TEST(SampleActions, SharpeningGoesOffFromAnyAmount) {
  DemoState state = default_demo_state();
  shown(state).taa.sharpen = 2;
  press(state, GLFW_KEY_SPACE);
  EXPECT_EQ(shown(state).taa.sharpen, 0);
  press(state, GLFW_KEY_SPACE);
  EXPECT_EQ(shown(state).taa.sharpen, 0.5f);
}

} // namespace
} // namespace unghost
