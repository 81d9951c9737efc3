#include "app/demo/recording_file.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "app/demo/file_values.h"
#include "app/failure.h"
#include "app/headless.h"
#include "tests/app/altered_setting.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using nlohmann::json;

/// What was drawn, as the demo draws it: each frame from the instant of the one before.
struct Drawn {
  Recorder recorder{"my car.glb", 7};
  DemoState state = default_demo_state();
  RigContext fit{.seed = 7, .track_radius = 120, .vehicle = {{-1, 0, -2}, {1, 1.5f, 2}}};
  std::optional<Instant> last;
  std::vector<FrameInput> inputs;
  std::vector<Moment> moments;

  void draw(Moment moment) {
    moment.index = 1000 + inputs.size();
    moment.cut |= inputs.empty();
    fit.stage = state.settings.stage, fit.light = state.settings.light;
    std::vector<ModeRun> modes;
    for (const size_t mode : modes_seen(state)) modes.push_back(state.modes[mode]);
    const Instant now = instant_of(moment, fit);
    inputs.push_back(frame_input(moment, now, last.value_or(now), state.settings, modes));
    moments.push_back(moment);
    recorder.add(moment, look_of(state, modes_seen(state)));
    last = now;
  }
};

/// Every way in which a frame can be another than the one before.
Drawn drawn_path() {
  Drawn drawn;
  Moment moment{.rig = "pass", .rig_frame = 500, .size = {320, 180}};
  const auto on = [&] { ++moment.rig_frame, drawn.draw(moment); };
  drawn.draw(moment);
  on();
  show_mode(drawn.state, place_of_mode(drawn.state, "blend"));
  drawn.state.modes[drawn.state.mode].taa.alpha = 0.1f + 1e-8f;
  on();
  moment.camera = {.yaw = 1.0 / 3, .pitch = -0.1, .distance = std::nextafter(0.2, 1), .pan = {1e-300, 2, 3}};
  on();
  drawn.state.settings.stage.speed = 0.7f; // the rig is then elsewhere at once
  drawn.state.settings.light.sun_azimuth_deg = 12.34f;
  drawn.state.settings.view = View::motion;
  on();
  const glm::dquat turn = glm::normalize(glm::dquat(0.1, 0.7, -0.3, 0.2));
  moment.camera.flown = {.eye = {std::numbers::pi, -0.0, 1e5}, .camera = turn};
  drawn.state.arrangement = Arrangement::grid;
  drawn.state.compared = {place_of_mode(drawn.state, "dop32"), place_of_mode(drawn.state, "off")};
  moment.size = {160, 90};
  on();
  drawn.draw(moment); // nothing moves
  moment.rig = "rotate", moment.rig_frame = 3, moment.cut = true;
  drawn.draw(moment);
  moment.cut = false, moment.camera = {}, drawn.state.arrangement = Arrangement::single;
  on();
  return drawn;
}

void expect_same(const FrameInput& a, const FrameInput& b) {
  EXPECT_EQ(a.now, b.now);
  EXPECT_EQ(a.before, b.before);
  EXPECT_EQ(std::tuple(a.index, a.cut, a.width, a.height), std::tuple(b.index, b.cut, b.width, b.height));
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.modes, b.modes);
}

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

/// A small one, for files that are nearly right.
json whole() { return json::parse(drawn_path().recorder.text()); }

std::string refusal_of(const std::string& text) {
  const ScratchFolder folder;
  const auto file = folder.file("path.json", text);
  try {
    load_recording(file);
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit, Exit::input_refused);
    EXPECT_NE(std::string(failure.what()).find(file.string()), std::string::npos) << failure.what();
    return failure.what();
  }
  return {};
}

TEST(DemoRecordingFile, RefusesByNameWhatIsWrong) {
  const std::pair<const char*, const char*> hostile[] = {
      {R"([{"op": "replace", "path": "", "value": []}])", "it is no recording"},
      {R"([{"op": "replace", "path": "", "value": null}])", "it is no recording"},
      {R"([{"op": "replace", "path": "/format", "value": "path"}])", "it is no recording"},
      {R"([{"op": "replace", "path": "/format", "value": 1}])", "it is no recording"},
      {R"([{"op": "remove", "path": "/format"}])", "it is no recording"},
      {R"([{"op": "replace", "path": "/version", "value": 2}])", "version: this program reads 1"},
      {R"([{"op": "replace", "path": "/version", "value": "1"}])", "version: "},
      {R"([{"op": "remove", "path": "/seed"}])", "it has no 'seed'"},
      {R"([{"op": "add", "path": "/sead", "value": 1}])", "there is no 'sead'"},
      {R"([{"op": "replace", "path": "/seed", "value": -1}])", "seed: it is a whole number"},
      {R"([{"op": "replace", "path": "/seed", "value": 1.5}])", "seed: "},
      {R"([{"op": "replace", "path": "/scene", "value": 3}])", "scene: it is a word"},
      {R"([{"op": "replace", "path": "/program", "value": {}}])", "program: it is a word"},
      {R"([{"op": "replace", "path": "/frames", "value": []}])", "frames: it is a list of 1 to 36000"},
      {R"([{"op": "replace", "path": "/frames", "value": {}}])", "frames: "},
      {R"([{"op": "replace", "path": "/frames/1", "value": 1}])", "frame 1: it is an object"},
      {R"([{"op": "add", "path": "/frames/1/rigg", "value": 1}])", "frame 1: there is no 'rigg'"},
      {R"([{"op": "remove", "path": "/frames/0/cut"}])", "frame 0: cut: the first frame is one"},
      {R"([{"op": "replace", "path": "/frames/0/cut", "value": 1}])", "frame 0: cut: it is true or false"},
      {R"([{"op": "remove", "path": "/frames/0/size"}])", "frame 0: size: the first frame has one"},
      {R"([{"op": "replace", "path": "/frames/0/size", "value": "0x0"}])", "frame 0: size: a size is"},
      {R"([{"op": "replace", "path": "/frames/0/size", "value": "99999x2"}])", "frame 0: size: a size is"},
      {R"([{"op": "replace", "path": "/frames/0/size", "value": [1, 2]}])", "frame 0: size: it is a word"},
      {R"([{"op": "replace", "path": "/frames/0/rig", "value": "driv"}])", "did you mean 'drive'?"},
      {R"([{"op": "add", "path": "/frames/1/rig-frame", "value": 1e9}])", "rig-frame: it is a whole number"},
      {R"([{"op": "add", "path": "/frames/1/rig-frame", "value": 1000000001}])", "to 1000000000"},
      {R"([{"op": "add", "path": "/frames/1/index", "value": 18446744073709551615}])", "frame 1: index: "},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": []}])", "camera: it is an object"},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": {"roll": 1}}])",
       "camera: roll: a camera has none"},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": {"yaw": null}}])",
       "camera: yaw: it is a number"},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": {"yaw": "nan"}}])",
       "camera: yaw: it is a number"},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": {"pitch": 1e300}}])", "camera: pitch: "},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": {"distance": 0}}])", "camera: distance: "},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": {"pan": [1, 2]}}])", "pan: it is a list of 3"},
      {R"([{"op": "add", "path": "/frames/1/camera", "value": {"flown": {"eye": [0, 0, 0]}}}])",
       "flown: it has 'eye' and 'camera'"},
      {R"([{"op": "replace", "path": "/frames/5/camera/flown/camera", "value": [0, 0, 0, 0]}])",
       "frame 5: camera: flown: camera: it is a quaternion of length 1"},
      {R"([{"op": "replace", "path": "/frames/5/camera/flown/eye/0", "value": 1e7}])", "flown: eye: "},
      {R"([{"op": "add", "path": "/frames/1/settings", "value": {"alpha": 0.5}}])", "alpha is a mode's own"},
      {R"([{"op": "add", "path": "/frames/1/settings", "value": {"sun": 101}}])", "from 0 to 100"},
      {R"([{"op": "add", "path": "/frames/1/settings", "value": {"son": 1}}])", "did you mean 'sun'?"},
      {R"([{"op": "add", "path": "/frames/1/settings", "value": [1]}])", "settings: it is an object"},
      {R"([{"op": "add", "path": "/frames/1/modes", "value": {"bland": {}}}])", "did you mean 'blend'?"},
      {R"([{"op": "add", "path": "/frames/1/modes", "value": {"blend": {"rectify": "box"}}}])",
       "modes: blend: rectify has no 'box'"},
      {R"([{"op": "add", "path": "/frames/1/modes", "value": {"blend": {"blend": "attenuated"}}}])",
       "blend: blend=attenuated acts"},
      {R"([{"op": "add", "path": "/frames/1/shown", "value": []}])", "shown: it is a list of 1 to 4"},
      {R"([{"op": "add", "path": "/frames/1/shown", "value": ["off", "off"]}])", "shown: it has off twice"},
      {R"([{"op": "add", "path": "/frames/1/shown", "value": ["of"]}])", "did you mean 'off'?"},
      {R"([{"op": "add", "path": "/frames/1/shown", "value": ["off", "blend"]}])",
       "shown: 'single' does not show 2 modes"},
      {R"([{"op": "add", "path": "/frames/1/arrangement", "value": "grid"}])", "'grid' does not show 1 mode"},
      {R"([{"op": "add", "path": "/frames/1/arrangement", "value": "quad"}])", "no arrangement 'quad'"},
  };
  ASSERT_EQ(refusal_of(whole().dump()), "");
  for (const auto& [patch, sentence] : hostile) {
    const std::string said = refusal_of(whole().patch(json::parse(patch)).dump());
    EXPECT_NE(said.find(sentence), std::string::npos) << patch << ": " << said;
  }
}

TEST(DemoRecordingFile, RefusesAStageThatChangesOnTheWay) {
  for (const Setting& row : settings_table()) {
    Settings settings;
    alter(row, settings);
    if (row.per_mode || same_stage(settings.stage, Settings{}.stage)) continue;
    json file = whole();
    file["frames"][1]["settings"] = changed(settings, Settings{}, SettingsPart::shared);
    EXPECT_NE(refusal_of(file.dump()).find("frame 1: settings: the stage"), std::string::npos) << row.name;
  }
}

/// Cut off, with a byte that is another, with a piece that is there twice: read, or refused in a sentence.
TEST(DemoRecordingFile, DamageIsRefusedAndNeverMore) {
  const std::string text = drawn_path().recorder.text();
  const auto survives = [](const std::string& damaged) {
    try {
      recording_from_text(damaged);
      return true;
    } catch (const SettingError& error) {
      return !std::string(error.what()).empty();
    } catch (const json::exception&) {
      return true;
    }
  };
  for (size_t end = 0; end + 2 < text.size(); end += 7) EXPECT_NE(refusal_of(text.substr(0, end)), "") << end;
  uint64_t chance = 1;
  const auto next = [&](uint64_t below) {
    chance = chance * 6364136223846793005u + 1442695040888963407u;
    return (chance >> 33) % below;
  };
  for (int round = 0; round < 4000; ++round) {
    std::string damaged = text;
    for (uint64_t times = 1 + next(3); times-- > 0;)
      if (next(2) == 0)
        damaged[next(damaged.size())] = "0123456789-.eE\"{}[],:anul\xff\0"[next(27)];
      else
        damaged.insert(next(damaged.size()), damaged.substr(next(damaged.size()), next(40)));
    EXPECT_TRUE(survives(damaged)) << damaged;
  }
}

std::string repeated(const std::string& piece, size_t times) {
  std::string text;
  while (times-- > 0) text += piece;
  return text;
}

TEST(DemoRecordingFile, AFileThatIsNoneIsRefused) {
  const ScratchFolder folder;
  mkfifo((folder.path / "pipe").c_str(), 0600);
  const std::pair<std::filesystem::path, std::string> broken[] = {
      {folder.file("empty", ""), "is no JSON"},
      {folder.file("infinite", R"({"format": "unghost path", "seed": 1e999})"), "is no JSON"},
      {folder.file("nested", std::string(200'000, '[')), "is no JSON"},
      {folder.file("closed", std::string(200'000, '[') + std::string(200'000, ']')), "it is no recording"},
      {folder.file("values", "[0" + repeated(",0", 7'000'000) + "]"), "it holds more than a recording can"},
      {folder.file("objects", "[{}" + repeated(",{}", 5'000'000) + "]"),
       "it holds more than a recording can"},
      {folder.file("large", std::string(recording_limit + 1, ' ')), "more than 16777216 bytes"},
      {folder.path / "pipe", "no regular file"},
      {folder.path, "no regular file"},
      {folder.path / "none", "No such file"}};
  for (const auto& [file, sentence] : broken) {
    const Outcome run =
        outcome({"capture", "--replay", file.string(), "-o", (folder.path / "a.png").string()});
    EXPECT_EQ(run.exit, int(Exit::input_refused)) << file;
    EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
    EXPECT_NE(run.err.find(file.string()), std::string::npos) << run.err;
    EXPECT_FALSE(std::filesystem::exists(folder.path / "a.png"));
  }
}

class DemoReplayWords : public testing::Test {
protected:
  Outcome replayed(const std::string& command, const Words& more) const {
    Words words = {command, "--replay", file, "-o", (folder.path / "a.png").string()};
    words.insert(words.end(), more.begin(), more.end());
    return outcome(words);
  }

  ScratchFolder folder;
  std::string file = folder.file("path.json", drawn_path().recorder.text()).string();
};

TEST_F(DemoReplayWords, WhatTheFileSaysIsNotSaidTwice) {
  for (const Words& more :
       {Words{"car.glb"}, Words{"--rig", "drive"}, Words{"--seed", "1"}, Words{"--size", "10x10"},
        Words{"--settings", file}, Words{"--view", "motion"}, Words{"--set", "sun=1"}}) {
    const Outcome run = replayed("capture", more);
    EXPECT_EQ(run.exit, int(Exit::wrong_words)) << more[0];
    EXPECT_NE(run.err.find("does not go with --replay"), std::string::npos) << run.err;
  }
  for (const char* command : {"measure", "bench", "explain"})
    EXPECT_NE(outcome({command, "--replay", file}).err.find("there is no option '--replay'"),
              std::string::npos);
}

TEST_F(DemoReplayWords, FramesAndModesThatItDoesNotHaveAreRefused) {
  const std::tuple<const char*, Words, const char*> wrong[] = {
      {"capture", {"--frames", "10"}, "--frames 10 is beyond the last of 9 recorded frames"},
      {"capture", {"--frames", "6"}, "shows blend, dop32, off in frame 5 of its frames: --mode says which"},
      {"capture", {"--mode", "bland"}, "did you mean 'blend'?"},
      {"compare", {}, "shows blend in frame 8 of its frames: --modes says which"},
      {"compare", {"--modes", "blend,blend"}, "more than once"}};
  for (const auto& [command, more, sentence] : wrong) {
    const Outcome run = replayed(command, more);
    EXPECT_EQ(run.exit, int(Exit::wrong_words)) << sentence;
    EXPECT_NE(run.err.find(sentence), std::string::npos) << run.err;
  }
}

} // namespace
} // namespace unghost
