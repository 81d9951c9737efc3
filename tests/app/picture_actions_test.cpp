#include "app/demo/actions.h"

#include <set>

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/app/pressed.h"

namespace unghost {
namespace {

TEST(PictureActions, TheComparedModeIsHeldUpOnlyWhereItIsNotSeenAlready) {
  DemoState state = default_demo_state();
  const DemoState before = state;
  press(state, GLFW_KEY_K);
  EXPECT_EQ(state.message, "flicker: blend");
  EXPECT_TRUE(without_message(state) == before);
  press(state, GLFW_KEY_B);
  press(state, GLFW_KEY_K);
  EXPECT_EQ(state.message, "flicker: they are all shown");
}

TEST(PictureActions, TheMagnifierFollowsOnlyWhereItIsShown) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_V, true);
  EXPECT_EQ(state.message, "magnifier at the mouse: it is not shown");
  EXPECT_FALSE(state.magnifier_follows || state.magnifier.shown);
  press(state, GLFW_KEY_V);
  press(state, GLFW_KEY_V, true);
  EXPECT_TRUE(state.magnifier_follows && state.magnifier.shown);
}

TEST(PictureActions, APickedPixelIsForgotten) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_I);
  EXPECT_EQ(state.message, "pixel: none is picked: click on one");
  state.picked = {.mode = 0, .at = {0.5, 0.25}};
  EXPECT_EQ(pixel_of(*state.picked, {10, 8}), glm::ivec2(5, 2));
  EXPECT_EQ(pixel_of({.at = {1, 1}}, {10, 8}), glm::ivec2(9, 7)) << "the edge is the last one's";
  press(state, GLFW_KEY_I);
  EXPECT_FALSE(state.picked);
}

TEST(PictureActions, OneFrameIsForWhatIsPaused) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_PERIOD);
  EXPECT_FALSE(state.requests.step);
  press(state, GLFW_KEY_P);
  press(state, GLFW_KEY_PERIOD);
  EXPECT_TRUE(state.requests.step);
  EXPECT_TRUE(state.paused);
}

TEST(PictureActions, ViewsAreGoneThroughOnce) {
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
