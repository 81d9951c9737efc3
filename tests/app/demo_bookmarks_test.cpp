#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/recording.h"
#include "tests/app/pressed.h"

namespace unghost {
namespace {

/// As a frame of `state` shows it.
Instant view(const DemoState& state) {
  return instant_of({.rig = state.rig, .rig_frame = state.rig_frame, .camera = state.camera}, {});
}

/// A frame of that time was drawn, and the next one follows.
void draw(DemoState& state, uint64_t rig_frame) {
  state.rig_frame_shown = rig_frame;
  state.rig_frame = rig_frame + 1;
  state.requests = {};
}

/// Kept under two rigs and at two times.
DemoState with_two() {
  DemoState state = default_demo_state();
  state.camera.yaw = 0.5;
  draw(state, 40);
  press(state, GLFW_KEY_M);
  state.rig = "overhead";
  state.camera = {.distance = 2};
  draw(state, 90);
  press(state, GLFW_KEY_M);
  return state;
}

TEST(DemoBookmarks, BringTheSameViewAgain) {
  DemoState state = default_demo_state();
  state.camera = {.yaw = 0.3, .pitch = 0.1, .distance = 1.5, .pan = {1, 0, 0}};
  state.rig_frame = 40;
  const Instant kept = view(state);
  draw(state, 40);
  press(state, GLFW_KEY_M);
  EXPECT_EQ(state.message, "bookmark: 1 of 1");
  state.rig = "rotate", state.camera = {};
  draw(state, 500);
  EXPECT_NE(view(state), kept);
  press(state, GLFW_KEY_J);
  EXPECT_EQ(view(state), kept);
  EXPECT_TRUE(state.requests.drop_history);
  EXPECT_TRUE(state.requests.step); // also while paused
}

TEST(DemoBookmarks, TheirCameraIsTakenAboutAVehicleThatDrivesOn) {
  DemoState state = with_two();
  draw(state, 500);
  press(state, GLFW_KEY_J, true);
  EXPECT_EQ(state.camera, (CameraOffset{.yaw = 0.5}));
  EXPECT_EQ(state.rig, "overhead");
  EXPECT_EQ(state.rig_frame, 501u);
}

TEST(DemoBookmarks, AreGoneThroughOnceRound) {
  DemoState state = with_two();
  for (const char* message : {"bookmark: 1 of 2", "bookmark: 2 of 2", "bookmark: 1 of 2"}) {
    press(state, GLFW_KEY_J);
    EXPECT_EQ(state.message, message);
  }
  EXPECT_EQ(state.rig, "drive");
}

TEST(DemoBookmarks, OnlyTheOneThatIsShownIsForgotten) {
  DemoState state = with_two();
  const Bookmark second = state.bookmarks[1];
  press(state, GLFW_KEY_J);
  press(state, GLFW_KEY_M, true);
  EXPECT_EQ(state.bookmarks, std::vector{second});
  press(state, GLFW_KEY_M, true);
  EXPECT_EQ(state.message, "bookmark: none is shown: go to one");
  EXPECT_EQ(state.bookmarks, std::vector{second});
  press(state, GLFW_KEY_J);
  press(state, GLFW_KEY_M, true);
  press(state, GLFW_KEY_J);
  EXPECT_EQ(state.message, "bookmark: none is kept");
}

TEST(DemoBookmarks, OneBeforeTheShownOneCanBeForgotten) {
  DemoState state = with_two();
  forget_bookmark(state, 0); // as the panel does
  EXPECT_EQ(state.bookmark, 0u);
  EXPECT_EQ(state.bookmarks[0].rig, "overhead");
}

TEST(DemoBookmarks, HaveABound) {
  DemoState state = default_demo_state();
  for (size_t i = 0; i <= most_bookmarks; ++i) press(state, GLFW_KEY_M);
  EXPECT_EQ(state.bookmarks.size(), most_bookmarks);
  EXPECT_EQ(state.message, "bookmark: 100 are the most");
}

} // namespace
} // namespace unghost
