#include "app/demo/recording.h"

#include <gtest/gtest.h>

#include "tests/app/altered_setting.h"
#include "tests/app/drawn_path.h"

namespace unghost {
namespace {

TEST(DemoRecording, GivesTheFramesThatWereDrawnToTheBit) {
  const Drawn drawn = drawn_path();
  const Recording recording = recording_from_text(drawn.recorder.text());
  EXPECT_EQ(recording.scene, "my car.glb");
  EXPECT_EQ(recording.seed, 7u);
  ASSERT_EQ(recording.frames.size(), drawn.inputs.size());
  const RigContext fit{.track_radius = drawn.fit.track_radius, .vehicle = drawn.fit.vehicle};
  for (size_t i = 0; i < drawn.inputs.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(recording.frames[i].moment, drawn.moments[i]);
    expect_same(frame_input(recording, fit, i), drawn.inputs[i]);
  }
}

TEST(DemoRecording, IsFollowedByADemoThatWasElsewhere) {
  const Drawn drawn = drawn_path();
  const Recording recording = recording_from_text(drawn.recorder.text());
  DemoState state = default_demo_state();
  state.arrangement = Arrangement::difference;
  show_mode(state, place_of_mode(state, "rgb"));
  for (const Recording::Frame& frame : recording.frames) {
    const Look& look = recording.looks[frame.look];
    take_look(state, look);
    EXPECT_EQ(look_of(state, modes_seen(state)), look);
  }
}

TEST(DemoRecording, KeepsEverySetting) {
  Drawn drawn;
  drawn.draw({});
  for (const Setting& row : settings_table()) {
    Settings settings = settings_of(drawn.state, drawn.state.mode);
    alter(row, settings);
    const bool other_stage = !same_stage(settings.stage, drawn.state.settings.stage);
    if (refusal(settings) || other_stage) continue;
    drawn.state.modes[drawn.state.mode].taa = settings.taa;
    settings.taa = {};
    drawn.state.settings = settings;
    drawn.draw({});
    const Recording recording = recording_from_text(drawn.recorder.text());
    EXPECT_EQ(recording.looks.back(), look_of(drawn.state, modes_seen(drawn.state))) << row.name;
  }
}

TEST(DemoRecording, AFrameLikeTheOneBeforeTakesNoRoom) {
  Drawn drawn;
  Moment moment;
  drawn.draw(moment);
  const size_t before = drawn.recorder.text().size();
  for (int i = 0; i < 100; ++i) ++moment.rig_frame, drawn.draw(moment);
  EXPECT_EQ(drawn.recorder.text().size(), before + 100 * std::string(",\n{}").size());
}

TEST(DemoRecording, TakesNoOtherStageAndNoMoreThanAFileHolds) {
  Recorder recorder("asphalt", 1);
  DemoState state = default_demo_state();
  Look look = look_of(state, modes_seen(state)), other = look;
  other.settings.stage.speed = 0.1f;
  recorder.add({.cut = true}, look);
  EXPECT_EQ(recorder.why_not(other), "");
  other.settings.stage.model_scale = 2;
  EXPECT_EQ(recorder.why_not(other), "another stage");
  Moment moment{.rig_frame = 1};
  while (recorder.why_not(look).empty()) recorder.add(moment, look);
  EXPECT_EQ(recorder.frames(), most_recorded_frames);
  EXPECT_EQ(recorder.why_not(look), "it is as long as it can be");
  EXPECT_EQ(recording_from_text(recorder.text()).frames.size(), most_recorded_frames);
}

TEST(DemoRecording, IsShownUnderOtherModesAsTheyWereSet) {
  Drawn drawn;
  drawn.state.modes[place_of_mode(drawn.state, "dop32")].taa.alpha = 0.07f; // which is not shown
  drawn.draw({});
  drawn.state.arrangement = Arrangement::split;
  drawn.draw({});
  Recording recording = recording_from_text(drawn.recorder.text());
  show_only(recording, std::vector<std::string>{"dop32"});
  for (size_t i = 0; i < 2; ++i) {
    const FrameInput input = frame_input(recording, {}, i);
    ASSERT_EQ(input.modes.size(), 1u);
    EXPECT_EQ(input.modes[0].name, "dop32");
    EXPECT_EQ(input.modes[0].taa.alpha, 0.07f);
  }
  EXPECT_THROW(show_only(recording, std::vector<std::string>{"dop33"}), SettingError);
}

} // namespace
} // namespace unghost
