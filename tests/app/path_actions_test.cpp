#include "app/demo/actions.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "tests/app/pressed.h"

namespace unghost {
namespace {

TEST(PathActions, TheRigsCameraComesBack) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_HOME);
  EXPECT_EQ(state.message, "camera: it is where the rig has it");
  state.camera.yaw = 1;
  EXPECT_EQ(action_for_key(GLFW_KEY_HOME, false)->present(state), "moved");
  press(state, GLFW_KEY_HOME);
  EXPECT_EQ(state.message, "camera: the rig's");
  EXPECT_TRUE(state.camera == CameraOffset{});
}

TEST(PathActions, ARecordingBeginsAndEndsWithTheSameKey) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_O);
  EXPECT_EQ(state.message, "recording: begins");
  EXPECT_TRUE(state.requests.record);
  state.requests = {}, state.recorded = 12; // as the frames that follow leave it
  EXPECT_EQ(action_for_key(GLFW_KEY_O, false)->present(state), "12 frames");
  press(state, GLFW_KEY_O);
  EXPECT_EQ(state.message, "recording: ends");
}

TEST(PathActions, OneIsNotRecordedWhileAnotherIsReplayedNorTheOtherWayRound) {
  DemoState state = default_demo_state();
  press(state, GLFW_KEY_O, true);
  EXPECT_EQ(state.message, "replay: nothing was recorded");
  state.path_file = "path.json";
  state.recorded = 1;
  press(state, GLFW_KEY_O, true);
  EXPECT_EQ(state.message, "replay: a recording goes on");
  state.recorded.reset(), state.replayed = 1;
  press(state, GLFW_KEY_O);
  EXPECT_EQ(state.message, "recording: a replay goes on");
  EXPECT_FALSE(state.requests.record || state.requests.replay);
  press(state, GLFW_KEY_O, true);
  EXPECT_EQ(state.message, "replay: ends");
  EXPECT_TRUE(state.requests.replay);
}

} // namespace
} // namespace unghost
