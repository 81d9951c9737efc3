#include "app/demo/demo_state.h"

#include <set>

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/overlay.h"
#include "tests/app/pressed.h"

namespace unghost {
namespace {

TEST(DemoModes, TaaComesBackToWhatWasShown) {
  DemoState state = showing("dop32");
  press(state, GLFW_KEY_ENTER);
  EXPECT_EQ(shown(state).name, "off");
  press(state, GLFW_KEY_ENTER);
  EXPECT_EQ(shown(state).name, "dop32");
  while (shown(state).name != "off") press(state, GLFW_KEY_LEFT_BRACKET);
  press(state, GLFW_KEY_ENTER);
  EXPECT_EQ(shown(state).name, "blend"); // the last that was on
}

TEST(DemoModes, NoModeIsSeenTwice) {
  DemoState state = showing("grand-tour");
  state.compared = {place_of_mode(state, "blend"), place_of_mode(state, "off")};
  state.arrangement = Arrangement::grid;
  for (const Action& action : actions()) {
    perform(action, state);
    const std::vector<size_t> seen = modes_seen(state);
    EXPECT_EQ(std::set<size_t>(seen.begin(), seen.end()).size(), seen.size()) << action.what;
  }
  state = showing("grand-tour");
  press(state, GLFW_KEY_1); // blend, beside it
  EXPECT_EQ(shown(state).name, "blend");
  EXPECT_EQ(state.modes[state.compared.front()].name, "grand-tour");
}

TEST(DemoModes, NoModeIsComparedTwice) {
  DemoState state = showing("grand-tour");
  const size_t tour = state.mode, off = place_of_mode(state, "off"), blend = place_of_mode(state, "blend"),
               rgb = place_of_mode(state, "rgb");
  state.compared = {blend, off};
  compare_with(state, 0, off);
  EXPECT_EQ(state.compared, (std::vector<size_t>{off, blend}));
  compare_with(state, 1, rgb);
  EXPECT_EQ(state.compared, (std::vector<size_t>{off, rgb}));
  compare_with(state, 1, tour);
  EXPECT_EQ(state.mode, rgb);
  EXPECT_EQ(state.compared, (std::vector<size_t>{off, tour}));
  compare_one_more(state);
  EXPECT_EQ(state.compared, (std::vector<size_t>{off, tour, blend}));
}

TEST(DemoModes, DigitsShowTheFirstThatKeepAHistoryAndTheUsualOne) {
  std::vector<std::string> modes;
  for (const TaaMode& row : taa_modes())
    if (row.settings.policy.needs_history()) modes.emplace_back(row.name);
  ASSERT_GE(modes.size(), 10u);
  modes[9] = default_taa_mode;
  const int keys[] = {GLFW_KEY_1, GLFW_KEY_2, GLFW_KEY_3, GLFW_KEY_4, GLFW_KEY_5,
                      GLFW_KEY_6, GLFW_KEY_7, GLFW_KEY_8, GLFW_KEY_9, GLFW_KEY_0};
  DemoState state = showing("off");
  for (size_t i = 0; i < std::size(keys); ++i) {
    press(state, keys[i]);
    EXPECT_EQ(shown(state).name, modes[i]);
    EXPECT_EQ(action_for_key(keys[i], false)->what, "Show " + modes[i]);
  }
}

TEST(DemoModes, BracketsGoThroughAllModes) {
  for (const int key : {GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET}) {
    DemoState state = default_demo_state();
    std::set<size_t> seen;
    for (size_t i = 0; i < taa_modes().size(); ++i, press(state, key)) seen.insert(state.mode);
    EXPECT_EQ(seen.size(), taa_modes().size());
    EXPECT_EQ(shown(state).name, default_taa_mode);
  }
}

TEST(DemoModes, ComparingTakesWhatWasComparedLast) {
  DemoState state = default_demo_state();
  state.compared = {place_of_mode(state, "dop32")};
  press(state, GLFW_KEY_B);
  EXPECT_EQ(state.arrangement, Arrangement::split);
  EXPECT_EQ(modes_seen(state), (std::vector{state.mode, place_of_mode(state, "dop32")}));
  press(state, GLFW_KEY_B);
  EXPECT_EQ(state.arrangement, Arrangement::single);
  EXPECT_EQ(modes_seen(state), std::vector{state.mode});
  state.compared.clear();
  press(state, GLFW_KEY_B);
  EXPECT_EQ(modes_seen(state), (std::vector{state.mode, state.mode + 1}));
}

TEST(DemoModes, AnArrangementSaysHowManyModesAreSeen) {
  DemoState state = default_demo_state();
  state.compared = {0, 1, 2};
  const std::pair<Arrangement, size_t> counts[] = {{Arrangement::single, 1},
                                                   {Arrangement::split, 2},
                                                   {Arrangement::grid, 4},
                                                   {Arrangement::difference, 2},
                                                   {Arrangement::flip, 2}};
  for (const auto& [arrangement, count] : counts) {
    state.arrangement = arrangement;
    EXPECT_EQ(modes_seen(state).size(), count);
  }
}

TEST(DemoModes, WhatIsMadeOfTwoIsLabelledOnceWithBoth) {
  const DemoState usual = default_demo_state();
  const std::vector<size_t> seen{place_of_mode(usual, "blend"), place_of_mode(usual, "grand-tour")};
  const auto words = [&](Arrangement arrangement, std::span<const size_t> shown) {
    DemoState state = usual;
    state.arrangement = arrangement;
    std::vector<std::string> all;
    for (const Label& label : labels_of(state, {.arrangement = arrangement}, shown))
      all.push_back(label.words);
    return all;
  };
  EXPECT_EQ(words(Arrangement::flip, seen),
            std::vector<std::string>{"FLIP of blend and grand-tour: yellow is 1"});
  EXPECT_EQ(words(Arrangement::difference, seen), std::vector<std::string>{"blend - grand-tour, times 8"});
  EXPECT_EQ(words(Arrangement::flip, std::span(seen).first(1)), std::vector<std::string>{"blend"});
}

TEST(DemoModes, TheHistoryOfWhatIsComparedCanBeDropped) {
  DemoState state = showing("off");
  press(state, GLFW_KEY_BACKSPACE);
  EXPECT_FALSE(state.requests.drop_history);
  press(state, GLFW_KEY_B);
  press(state, GLFW_KEY_BACKSPACE);
  EXPECT_TRUE(state.requests.drop_history);
}

TEST(DemoModes, ANameOfNoModeGetsTheNearest) {
  try {
    place_of_mode(default_demo_state(), "grandtour");
    FAIL();
  } catch (const SettingError& error) {
    EXPECT_STREQ(error.what(), "there is no mode 'grandtour'; did you mean 'grand-tour'?");
  }
}

} // namespace
} // namespace unghost
