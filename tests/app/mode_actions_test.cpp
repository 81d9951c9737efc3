#include "app/demo/actions.h"

#include <set>

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/app/pressed.h"

namespace unghost {
namespace {

TEST(ModeActions, ArrangementsOfSeveralModesAreGoneThrough) {
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

TEST(ModeActions, AGridGrowsToFourAndShrinksToTwo) {
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

TEST(ModeActions, AModeAndEverythingCanBeReset) {
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

} // namespace
} // namespace unghost
