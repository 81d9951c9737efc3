#include "app/demo/demo_file.h"

#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "app/demo/file_values.h"
#include "app/failure.h"
#include "tests/app/altered_setting.h"
#include "tests/app/child.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using nlohmann::json;

DemoState other_than_default() {
  DemoState state = default_demo_state();
  state.rig = "pass";
  state.seed = 18446744073709551615u;
  state.settings.view = View::motion;
  state.settings.light.exposure_ev = 0.3f;
  state.settings.stage.speed = 0.1f;
  state.modes[1].taa.alpha = 0.07f;
  state.modes[6].taa.policy.rectify = Rectify::dop_clip;
  state.modes[6].taa.policy.reject = Reject::nothing;
  state.modes[0].taa.sharpen = 2;
  state.mode = 3;
  state.compared = {6, 0, 1};
  state.arrangement = Arrangement::grid;
  state.split = 0.1;
  state.magnifier = {.shown = true, .centre = {0.3, 0.7}};
  state.magnifier_follows = true;
  state.panel = false;
  state.render_scale = 0.7;
  state.frame_ms = 16.6;
  const glm::dquat turn = glm::normalize(glm::dquat(0.1, 0.7, -0.3, 0.2));
  state.bookmarks = {{.rig = "pass", .rig_frame = 77, .camera = {.yaw = 1.0 / 3, .pan = {0, -0.1, 3e-9}}},
                     {.rig_frame = latest_frame, .camera = {.distance = 0.3}},
                     {.camera = {.flown = CameraOffset::Flown{.eye = {1, 2.1, -1e6}, .camera = turn}}}};
  return state;
}

DemoState after(const json& object, DemoState state = default_demo_state()) {
  apply_demo_json(state, object);
  return state;
}

std::string complaint_of(const json& object) {
  DemoState state = other_than_default();
  try {
    apply_demo_json(state, object);
  } catch (const SettingError& error) {
    EXPECT_TRUE(state == other_than_default()) << object.dump();
    return error.what();
  }
  return {};
}

TEST(DemoFile, GoesThereAndBack) {
  for (const DemoState& state : {default_demo_state(), other_than_default()}) {
    EXPECT_TRUE(after(json::parse(demo_json(state).dump())) == state);
    EXPECT_TRUE(after(demo_json(state), other_than_default()) == state); // whatever was there
  }
}

TEST(DemoFile, KeepsEverySetting) {
  for (const Setting& row : settings_table()) {
    DemoState state = default_demo_state();
    Settings settings = settings_of(state, state.mode);
    alter(row, settings);
    if (refusal(settings)) continue;
    state.modes[state.mode].taa = settings.taa;
    settings.taa = {};
    state.settings = settings;
    EXPECT_FALSE(state == default_demo_state()) << row.name;
    EXPECT_TRUE(after(demo_json(state)) == state) << row.name << demo_json(state).dump(1);
  }
}

TEST(DemoFile, HoldsOfSettingsOnlyWhatWasChanged) {
  EXPECT_EQ(demo_json(default_demo_state())["settings"], json::object());
  EXPECT_EQ(demo_json(default_demo_state())["modes"], json::object());
  EXPECT_EQ(demo_json(other_than_default())["modes"],
            json::parse(R"({"blend": {"alpha": 0.07}, "off": {"sharpen": 2.0},
                            "grand-tour": {"rectify": "dop-clip", "reject": "nothing"}})"));
}

TEST(DemoFile, KeepsNeitherSceneNorCameraNorWhatPasses) {
  DemoState state = default_demo_state();
  state.scene = "car.glb";
  state.camera.yaw = 1;
  state.rig_frame = state.rig_frame_shown = 5;
  state.recorded = state.replayed = 3, state.path_file = "path.json";
  state.paused = state.hidden = state.keys = state.flicker = state.requests.leave = true;
  state.moving = false;
  state.message = "word";
  EXPECT_EQ(demo_json(state), demo_json(default_demo_state()));
  EXPECT_TRUE(after(demo_json(default_demo_state()), state) == state);
}

TEST(DemoFile, WhatIsNotNamedStays) {
  DemoState expected = other_than_default();
  EXPECT_TRUE(after(json::object(), other_than_default()) == expected);
  expected.rig = "rotate";
  EXPECT_TRUE(after({{"rig", "rotate"}}, other_than_default()) == expected);
}

TEST(DemoFile, AComparedModeThatIsNotNamedMakesRoomForTheShownOne) {
  DemoState state = default_demo_state(), pressed = state;
  const size_t compared = state.compared.front();
  show_mode(pressed, compared);
  apply_demo_json(state, {{"shown", state.modes[compared].name}});
  EXPECT_EQ(modes_seen(state), modes_seen(pressed));
  EXPECT_EQ(state.compared, pressed.compared);
}

TEST(DemoFile, RefusesNonsenseAndLeavesTheStateAsItWas) {
  const std::pair<const char*, const char*> hostile[] = {
      {R"([])", "object"},
      {R"(null)", "object"},
      {R"("drive")", "object"},
      {R"({"rigg": "drive"})", "there is no 'rigg'"},
      {R"({"rig": "driv"})", "did you mean 'drive'?"},
      {R"({"rig": 1})", "rig: it is a word"},
      {R"({"seed": -1})", "seed: "},
      {R"({"seed": 1.5})", "seed: "},
      {R"({"seed": 18446744073709551616})", "seed: "},
      {R"({"seed": "1"})", "seed: "},
      {R"({"settings": {"alpha": 0.5}})", "alpha is a mode's own"},
      {R"({"settings": {"sun": 101}})", "from 0 to 100"},
      {R"({"settings": {"sun": 1e300}})", "from 0 to 100"},
      {R"({"settings": {"sun": "nan"}})", "from 0 to 100"},
      {R"({"settings": {"sun": null}})", "sun is a number or a word"},
      {R"({"settings": {"son": 1}})", "did you mean 'sun'?"},
      {R"({"settings": []})", "settings: it is an object"},
      {R"({"modes": []})", "modes: it is an object"},
      {R"({"modes": {"bland": {}}})", "did you mean 'blend'?"},
      {R"({"modes": {"blend": 1}})", "modes: it is an object"},
      {R"({"modes": {"blend": {"view": "motion"}}})", "view is shared by all modes"},
      {R"({"modes": {"blend": {"rectify": "box"}}})", "rectify has no 'box'"},
      {R"({"modes": {"blend": {"blend": "attenuated"}}})", "blend: blend=attenuated acts"},
      {R"({"modes": {"off": {"rectify": "box-clip"}}})",
       "off: rectify=box-clip has no effect: blend=current keeps no history"},
      {R"({"shown": "none"})", "shown: there is no mode 'none'"},
      {R"({"shown": 3})", "shown: it is a word"},
      {R"({"compared": ["blend"], "shown": "blend"})", "seen twice"},
      {R"({"compared": []})", "compared: it is a list of 1 to 3"},
      {R"({"compared": ["off", "blend", "dop32", "rgb"]})", "compared: it is a list of 1 to 3"},
      {R"({"compared": ["off", "off"]})", "compared: off is seen twice"},
      {R"({"compared": ["off", 1]})", "compared: it is a word"},
      {R"({"compared": "off"})", "compared: it is a list"},
      {R"({"arrangement": "quad"})", "there is no arrangement 'quad'"},
      {R"({"arrangement": 2})", "arrangement: it is a word"},
      {R"({"split": 1.01})", "split: it is a number from 0.0 to 1.0"},
      {R"({"split": -1e-9})", "split: "},
      {R"({"split": true})", "split: "},
      {R"({"split": "0.5"})", "split: "},
      {R"({"magnifier": 1})", "magnifier: it is true or false"},
      {R"({"magnified": [0.5]})", "magnified: it is a list of 2"},
      {R"({"magnified": [0.5, 2]})", "magnified: it is a number"},
      {R"({"magnified": {"x": 1}})", "magnified: "},
      {R"({"panel": null})", "panel: "},
      {R"({"render-scale": 0.1})", "render-scale: it is a number from 0.5 to 1.0"},
      {R"({"render-scale": 4})", "render-scale: "},
      {R"({"frame-ms": 0})", "frame-ms: "},
      {R"({"frame-ms": "16"})", "frame-ms: "},
      {R"({"bookmarks": {}})", "bookmarks: it is a list of 0 to 100"},
      {R"({"bookmarks": [1]})", "bookmarks: it is an object"},
      {R"({"bookmarks": [{"rig": "driv"}]})", "did you mean 'drive'?"},
      {R"({"bookmarks": [{"frame": 1}]})", "bookmarks: frame: a bookmark has none"},
      {R"({"bookmarks": [{"rig-frame": -1}]})", "rig-frame: it is a whole number"},
      {R"({"bookmarks": [{"camera": {"yaw": "1"}}]})", "bookmarks: camera: yaw: it is a number"},
      {R"({"bookmarks": [{"camera": {"flown": {"eye": [0, 0, 0], "camera": [2, 0, 0, 0]}}}]})",
       "flown: camera: it is a number from -1.0 to 1.0"},
      {R"({"rig": "still", "split": 7})", "split: "}, // what is right before what is wrong
  };
  for (const auto& [text, sentence] : hostile)
    EXPECT_NE(complaint_of(json::parse(text)).find(sentence), std::string::npos)
        << text << ": " << complaint_of(json::parse(text));
}

TEST(DemoFile, IsSavedAndLoaded) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder.path / "deep" / "unghost" / "config.json";
  save_demo(other_than_default(), file);
  const LoadedDemo loaded = load_demo(file);
  EXPECT_EQ(loaded.complaint, "");
  EXPECT_TRUE(loaded.state == other_than_default());
  save_demo(default_demo_state(), file);
  EXPECT_TRUE(load_demo(file).state == default_demo_state());
}

TEST(DemoFile, WithoutAFileAreTheDefaults) {
  const ScratchFolder folder;
  for (const std::filesystem::path& file : {folder.path / "config.json", std::filesystem::path()}) {
    const LoadedDemo loaded = load_demo(file);
    EXPECT_EQ(loaded.complaint, "");
    EXPECT_TRUE(loaded.state == default_demo_state());
  }
  save_demo(default_demo_state(), {});
  EXPECT_EQ(folder.count(), 0u);
}

TEST(DemoFile, ABrokenFileIsTheDefaultsAndASentence) {
  const ScratchFolder folder;
  mkfifo((folder.path / "pipe").c_str(), 0600);
  std::filesystem::create_directory(folder.path / "folder");
  std::filesystem::create_symlink(folder.path / "nothing", folder.path / "link");
  const std::pair<std::filesystem::path, std::string> broken[] = {
      {folder.file("empty", ""), "is no JSON"},
      {folder.file("half", demo_json(other_than_default()).dump().substr(0, 300)), "is no JSON"},
      {folder.file("bytes", std::string("\x80\xff\0\x01", 4)), "is no JSON"},
      {folder.file("latin", "{\"rig\": \"dr\xfcve\"}"), "is no JSON"},
      {folder.file("infinite", R"({"split": 1e999})"), "is no JSON"},
      {folder.file("nested", std::string(200'000, '[')), "is no JSON"},
      {folder.file("closed", std::string(200'000, '[') + std::string(200'000, ']')), "it is an object"},
      {folder.file("large", std::string((1 << 20) + 1, ' ')), "more than 1048576 bytes"},
      {folder.file("wrong", R"({"rig": "pass", "split": 7})"), "split: it is a number"},
      {folder.path / "pipe", "no regular file"},
      {folder.path / "folder", "no regular file"},
      {folder.path / "link", "No such file"}};
  for (const auto& [file, sentence] : broken) {
    const LoadedDemo loaded = load_demo(file);
    EXPECT_TRUE(loaded.state == default_demo_state()) << file;
    EXPECT_NE(loaded.complaint.find(sentence), std::string::npos) << loaded.complaint;
    EXPECT_NE(loaded.complaint.find(file.string()), std::string::npos) << loaded.complaint;
    EXPECT_NE(loaded.complaint.find("; the defaults are taken, and it is kept as "), std::string::npos)
        << loaded.complaint;
  }
}

TEST(DemoFile, ABrokenFileOutlivesWhatIsSavedInItsPlace) {
  const ScratchFolder folder;
  for (const std::string slip : {"{\"rig\": \"drive\",}", "another"}) {
    const std::filesystem::path file = folder.file("config.json", slip);
    save_demo(load_demo(file).state, file);
    EXPECT_EQ(load_demo(file).complaint, "");
    const std::filesystem::path aside =
        folder.path / (slip == "another" ? "config.json.refused-2" : "config.json.refused-1");
    EXPECT_EQ(content_of(aside), slip);
  }
  EXPECT_EQ(content_of(folder.path / "config.json.refused-1"), "{\"rig\": \"drive\",}");
}

TEST(DemoFile, IsSavedWholeOrNotAtAll) {
  const ScratchFolder folder;
  folder.file("file", "");
  EXPECT_THROW(save_demo(default_demo_state(), folder.path / "file" / "config.json"), Failure);
  save_demo(default_demo_state(), folder.path / "config.json");
  EXPECT_EQ(folder.count(), 2u); // and nothing passing
}

/// The variable as it was, again, when the test is over.
class Variable {
public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    value != nullptr ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { before_ ? setenv(name_, before_->c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

private:
  const char* name_;
  std::optional<std::string> before_;
};

std::filesystem::path config_file_with(const char* config, const char* home) {
  const Variable xdg("XDG_CONFIG_HOME", config), user("HOME", home);
  return config_file();
}

TEST(DemoFile, LiesWhereAPersonsSettingsDo) {
  EXPECT_EQ(config_file_with("/c", "/h"), "/c/unghost/config.json");
  EXPECT_EQ(config_file_with(nullptr, "/h"), "/h/.config/unghost/config.json");
  EXPECT_EQ(config_file_with("", "/h"), "/h/.config/unghost/config.json");
  EXPECT_EQ(config_file_with("relative", "/h"), "/h/.config/unghost/config.json");
  EXPECT_EQ(config_file_with(nullptr, nullptr), "");
}

} // namespace
} // namespace unghost
