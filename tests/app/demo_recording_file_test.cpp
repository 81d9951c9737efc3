#include "app/demo/recording_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "app/demo/file_values.h"
#include "app/failure.h"
#include "tests/app/altered_setting.h"
#include "tests/app/drawn_path.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using nlohmann::json;

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

} // namespace
} // namespace unghost
