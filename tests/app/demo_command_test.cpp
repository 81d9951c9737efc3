#include "app/demo/demo_command.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/actions.h"
#include "app/shot.h"
#include "tests/app/altered_setting.h"

namespace unghost {
namespace {

Shot shot_of(const std::string& line) {
  Words words = words_of_line(line);
  EXPECT_EQ(words.front(), "unghost");
  words.erase(words.begin());
  return shot_from(command_line_of(words));
}

/// That the line of `state` draws it: each setting that has an effect.
void expect_same(const DemoState& state) {
  const std::string line = command_of(state);
  const Shot shot = shot_of(line);
  const std::vector<size_t> seen = modes_seen(state);
  EXPECT_EQ(shot.command, seen.size() > 1 ? "compare" : "capture");
  EXPECT_EQ(shot.scene, state.scene);
  EXPECT_EQ(shot.rig, state.rig);
  EXPECT_EQ(shot.seed, state.seed);
  ASSERT_EQ(shot.modes.size(), seen.size());
  for (size_t i = 0; i < seen.size(); ++i) {
    EXPECT_EQ(shot.modes[i].name, state.modes[seen[i]].name);
    const Settings shown = settings_of(state, seen[i]);
    Settings drawn = shot.settings;
    drawn.taa = shot.modes[i].taa;
    for (const Setting& row : settings_table())
      if (row.used.met_by(shown)) {
        EXPECT_EQ(row.get(drawn), row.get(shown)) << line;
      }
  }
}

TEST(DemoCommand, SaysOnlyWhatDiffers) {
  DemoState state = default_demo_state();
  EXPECT_EQ(command_of(state), "unghost capture --mode unghost -o unghost.png");
  state.arrangement = Arrangement::difference;
  EXPECT_EQ(command_of(state), "unghost compare --modes unghost,blend -o unghost.png");
  state.arrangement = Arrangement::single;
  state.scene = "my car.glb";
  state.rig = "pass";
  state.seed = 7;
  state.settings.view = View::motion;
  state.modes[state.mode].taa.alpha = 0.07f;
  EXPECT_EQ(command_of(state), "unghost capture 'my car.glb' --mode unghost --rig pass --seed 7 --set "
                               "alpha=0.07 --set view=motion -o unghost.png");
  expect_same(state);
}

TEST(DemoCommand, GivesTheSameSettingsToTheBit) {
  DemoState state = default_demo_state();
  TaaSettings& taa = state.modes[state.mode].taa;
  taa.alpha = 0.1f + 1e-7f;
  taa.policy.reject = Reject::nothing;
  taa.policy.rectify = Rectify::dop_variance;
  taa.gamma = 1.0f / 3;
  state.settings.light.sun_azimuth_deg = -35.5f;
  EXPECT_EQ(shot_of(command_of(state)).modes.front().taa, taa);
  Settings shared = shot_of(command_of(state)).settings;
  shared.taa = state.settings.taa;
  EXPECT_EQ(shared, state.settings);
}

TEST(DemoCommand, DrawsEverySettingOfEveryMode) {
  for (size_t mode = 0; mode < default_demo_state().modes.size(); ++mode)
    for (const Setting& row : settings_table()) {
      DemoState state = default_demo_state();
      show_mode(state, mode);
      Settings settings = settings_of(state, mode);
      if (!row.used.met_by(settings)) continue;
      alter(row, settings);
      if (refusal(settings)) continue;
      state.modes[mode].taa = settings.taa;
      settings.taa = {};
      state.settings = settings;
      expect_same(state);
    }
}

TEST(DemoCommand, DrawsWhatEveryKeyLeadsTo) {
  DemoState state = default_demo_state();
  for (const Action& action : actions()) {
    if (action.key == GLFW_KEY_B) continue; // modes with settings of their own, below
    perform(action, state);
    expect_same(state);
  }
}

TEST(DemoCommand, LeavesOutWhatHasNoEffect) {
  DemoState state = default_demo_state();
  TaaSettings& taa = state.modes[state.mode].taa;
  taa.gamma = 3; // without a variance
  EXPECT_EQ(command_of(state), "unghost capture --mode unghost -o unghost.png");
  taa.policy.rectify = Rectify::variance_clip;
  expect_same(state);
  EXPECT_NE(command_of(state).find("gamma=3"), std::string::npos);
}

TEST(DemoCommand, ComparesModesThatAreChangedAlike) {
  DemoState state = default_demo_state();
  state.arrangement = Arrangement::grid;
  state.compared = {place_of_mode(state, "off"), place_of_mode(state, "uncharted")};
  for (const size_t mode : {state.mode, state.compared[1]}) state.modes[mode].taa.alpha = 0.2f;
  expect_same(state); // off has no alpha
  EXPECT_EQ(command_of(state),
            "unghost compare --modes unghost,off,uncharted --set alpha=0.2 -o unghost.png");
}

TEST(DemoCommand, SaysWhereNoLineDrawsTheSame) {
  DemoState state = default_demo_state();
  state.arrangement = Arrangement::split;
  state.modes[state.mode].taa.alpha = 0.2f; // and not uncharted's
  try {
    command_of(state);
    FAIL();
  } catch (const SettingError& error) {
    EXPECT_NE(std::string(error.what()).find("unlike values of alpha"), std::string::npos) << error.what();
  }
  state = default_demo_state();
  state.scene = "two\nlines.glb";
  EXPECT_THROW(command_of(state), std::invalid_argument);
}

} // namespace
} // namespace unghost
