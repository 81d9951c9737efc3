#include "app/shot.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/failure.h"
#include "app/headless.h"
#include "app/png_file.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

Shot shot_of(std::vector<const char*> words) {
  return shot_from(std::get<CommandLine>(parse_command_line(words)));
}

std::string complaint(std::vector<const char*> words) {
  try {
    shot_of(std::move(words));
  } catch (const SettingError& error) {
    return error.what();
  }
  return {};
}

std::string refusal_of(std::vector<const char*> words) {
  try {
    shot_of(std::move(words));
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit, Exit::input_refused);
    return failure.what();
  }
  return {};
}

TEST(Shot, HasDefaults) {
  const Shot shot = shot_of({"capture"});
  EXPECT_EQ(shot.scene, "asphalt");
  EXPECT_EQ(shot.frames, 64u);
  EXPECT_EQ(text_of(shot.size), "1280x720");
  ASSERT_EQ(shot.modes.size(), 1u);
  EXPECT_EQ(shot.modes[0].taa, settings_for_mode(shot.modes[0].name).taa);
}

TEST(Shot, WordsWin) {
  const Shot shot =
      shot_of({"capture", "car.glb", "--mode", "blend", "--size=64x32", "--frames", "5", "--seed", "9",
               "--rig", "pass", "--view", "motion", "--set", "alpha=0.25", "--set", "sun=2"});
  EXPECT_EQ(shot.scene, "car.glb");
  EXPECT_EQ(shot.modes[0].taa.alpha, 0.25f);
  EXPECT_EQ(shot.settings.light.sun_illuminance, 2);
  EXPECT_EQ(shot.settings.view, View::motion);
  EXPECT_EQ(shot.size.width, 64u);
  EXPECT_EQ(shot.seed, 9u);
}

TEST(Shot, WhatAModesNameSaysWinsOverTheWords) {
  const Shot shot = shot_of({"compare", "--modes", "unghost,unghost:alpha=0.2", "--set", "alpha=0.1"});
  EXPECT_EQ(shot.modes[0].taa.alpha, 0.1f);
  EXPECT_EQ(shot.modes[1].taa.alpha, 0.2f);
  EXPECT_NE(complaint({"compare", "--modes", "unghost:alpha=0.2,rgb:alpha=0.3", "--set", "alpha=0.1"})
                .find("alpha=0.1 has no effect: every mode here says its own"),
            std::string::npos);
  EXPECT_NE(complaint({"compare", "--modes", "rgb-var:gamma=2,rgb", "--set", "gamma=1"})
                .find("gamma=1 has no effect on those that do not say their own: no variance"),
            std::string::npos)
      << "no other has a use for it";
  EXPECT_NE(complaint({"compare", "--modes", "rgb-var:gamma=2,rgb", "--set", "rectify=none"})
                .find("rgb-var:gamma=2: gamma=2 has no effect: no variance"),
            std::string::npos)
      << "the words leave it no use";
  EXPECT_NE(complaint({"bench", "--modes", "rgb,rgb:texture-jitter=removed"})
                .find("rgb:texture-jitter=removed: texture-jitter=removed has no effect"),
            std::string::npos)
      << "times are taken without jitter";
}

TEST(Shot, ASettingReachesTheModesThatUseIt) {
  const Shot shot = shot_of(
      {"compare", "--modes", "off,blend,grand-tour", "--set", "history=catmull-rom", "--set", "near=4"});
  EXPECT_EQ(shot.modes[0].taa, settings_for_mode("off").taa);
  EXPECT_EQ(shot.modes[1].taa.policy.history, HistoryFilter::catmull_rom);
  EXPECT_EQ(shot.modes[1].taa.near_m, TaaSettings{}.near_m);
  EXPECT_EQ(shot.modes[2].taa.near_m, 4);
}

TEST(Shot, ASettingThatNothingUsesIsRefusedWithTheReason) {
  EXPECT_NE(complaint({"capture", "--mode", "off", "--set", "alpha=0.5"}).find("blend=current"),
            std::string::npos);
  EXPECT_NE(complaint({"capture", "--mode", "blend", "--set", "near=4"}).find("near-moving"),
            std::string::npos);
  EXPECT_EQ(complaint({"capture", "--mode", "off", "--set", "blend=constant", "--set", "alpha=0.5"}), "");
  EXPECT_NE(complaint({"capture", "--mode", "grand-tour", "--set", "near=40", "--set", "far=20"})
                .find("less than far"),
            std::string::npos);
}

TEST(Shot, UnknownNamesGetTheNearest) {
  EXPECT_NE(complaint({"capture", "--rig", "driv"}).find("'drive'"), std::string::npos);
  EXPECT_NE(complaint({"capture", "--mode", "grandtour"}).find("'grand-tour'"), std::string::npos);
  EXPECT_NE(complaint({"capture", "--view", "colr"}).find("'colour'"), std::string::npos);
}

TEST(Shot, APictureDrawsItselfAgain) {
  const Shot shot =
      shot_of({"capture", "car.glb", "--mode", "uncharted", "--size", "64x32", "--rig", "rotate", "--seed",
               "4", "--set", "alpha=0.123", "--set", "exposure=-0.7", "--view", "tag"});
  const Image pixel{.name = "", .width = 1, .height = 1, .rgba = {1, 2, 3, 255}};
  const std::vector<uint8_t> png = encode_png(pixel, shot_json(shot, 17).dump());
  const ScratchFolder folder;
  const auto file = folder.file("shot.png", {png.begin(), png.end()});
  const Shot again = shot_of({"capture", "--settings", file.c_str()});
  EXPECT_EQ(shot_json(again, again.frames), shot_json(shot, 17));
  EXPECT_EQ(again.modes[0].taa, shot.modes[0].taa);
  const Shot changed =
      shot_of({"capture", "--settings", file.c_str(), "--set", "alpha=0.5", "--frames", "3"});
  EXPECT_EQ(changed.modes[0].taa.alpha, 0.5f);
  EXPECT_EQ(changed.modes[0].name, "uncharted");
  EXPECT_EQ(changed.frames, 3u);
}

TEST(Shot, AComparisonDrawsItselfAgain) {
  const Shot shot = shot_of({"compare", "--modes", "blend,uncharted", "--set", "alpha=0.2", "--no-crops"});
  const ScratchFolder folder;
  const auto file = folder.file("shot.json", shot_json(shot, 9).dump());
  const Shot again = shot_of({"compare", "--settings", file.c_str()});
  EXPECT_EQ(shot_json(again, again.frames), shot_json(shot, 9));
}

TEST(Shot, PlainSettingsReachEveryMode) {
  const ScratchFolder folder;
  const auto file = folder.file("calm.json", R"({"alpha": 0.02, "sun": 0.5})");
  const Shot shot = shot_of({"compare", "--modes", "blend,uncharted", "--settings", file.c_str()});
  EXPECT_EQ(shot.settings.light.sun_illuminance, 0.5f);
  for (const ModeRun& run : shot.modes) EXPECT_EQ(run.taa.alpha, 0.02f) << run.name;
}

TEST(Shot, PlainSettingsFollowTheRuleOfSet) {
  const ScratchFolder folder;
  const auto file = folder.file("sharp.json", R"({"history": "catmull-rom", "near": 4})");
  const Shot shot = shot_of({"compare", "--settings", file.c_str()});
  EXPECT_EQ(shot.modes[0].taa, settings_for_mode("off").taa);
  EXPECT_EQ(shot.modes[1].taa.policy.history, HistoryFilter::catmull_rom);
  EXPECT_EQ(shot.modes[1].taa.near_m, TaaSettings{}.near_m);
  EXPECT_EQ(shot.modes[2].taa.near_m, 4);
  const std::string refused = refusal_of({"compare", "--modes", "off,blend", "--settings", file.c_str()});
  EXPECT_NE(refused.find("sharp.json: near=4 has no effect"), std::string::npos) << refused;
  EXPECT_EQ(shot_of({"capture", "--mode", "off", "--settings", file.c_str(), "--set", "blend=constant",
                     "--set", "reject=near-moving"})
                .modes[0]
                .taa.near_m,
            4);
}

TEST(Shot, AFileOfSeveralModesIsNotGuessedAt) {
  const Shot grid = shot_of({"compare", "--modes", "blend,uncharted", "--set", "alpha=0.2"});
  const ScratchFolder folder;
  const auto file = folder.file("grid.json", shot_json(grid, 9).dump());
  EXPECT_NE(
      complaint({"capture", "--settings", file.c_str()}).find("grid.json shows blend, uncharted: --mode"),
      std::string::npos);
  EXPECT_NE(complaint({"capture", "--settings", file.c_str(), "--mode", "off"}).find("no 'off'"),
            std::string::npos);
  const Shot one = shot_of({"capture", "--settings", file.c_str(), "--mode", "uncharted"});
  EXPECT_EQ(one.modes[0].taa, grid.modes[1].taa);
  const Shot wider = shot_of({"compare", "--settings", file.c_str(), "--modes", "off,blend"});
  EXPECT_EQ(wider.modes[0].taa, settings_for_mode("off").taa);
  EXPECT_EQ(wider.modes[1].taa, grid.modes[0].taa);
}

TEST(Shot, APictureOfOneModeIsNoComparison) {
  const Shot picture = shot_of({"capture", "--mode", "uncharted", "--set", "alpha=0.2"});
  const ScratchFolder folder;
  const auto file = folder.file("one.json", shot_json(picture, 9).dump());
  for (const char* command : {"compare", "measure"})
    EXPECT_NE(complaint({command, "--settings", file.c_str()}).find("one.json shows one mode, uncharted"),
              std::string::npos);
  const Shot beside = shot_of({"compare", "--settings", file.c_str(), "--modes", "blend,uncharted"});
  EXPECT_EQ(beside.modes[0].taa, settings_for_mode("blend").taa);
  EXPECT_EQ(beside.modes[1].taa, picture.modes[0].taa);
}

TEST(Shot, AllModesAreAllRows) {
  const Shot shot = shot_of({"compare", "--modes", "all"});
  ASSERT_EQ(shot.modes.size(), taa_modes().size());
  for (size_t i = 0; i < shot.modes.size(); ++i) EXPECT_EQ(shot.modes[i].name, taa_modes()[i].name);
}

TEST(Shot, RunTimesHaveNoJitterAndMeasurementsOneOfTheirOwn) {
  const nlohmann::json said = shot_json(shot_of({"bench"}), 32);
  for (const auto& mode : said.at("modes")) EXPECT_EQ(mode.at("settings").at("jitter"), "none");
  const ScratchFolder folder;
  const auto file = folder.file("moved.json", R"({"jitter": "halton-8"})");
  const std::string refused = refusal_of({"measure", "--settings", file.c_str()});
  EXPECT_NE(refused.find("moved.json: jitter=halton-8 has no effect"), std::string::npos) << refused;
  EXPECT_THROW(shot_of({"measure", "--modes", "rgb:jitter=none"}), SettingError);
  EXPECT_THROW(shot_of({"bench", "--modes", "rgb:jitter-scale=0.5"}), SettingError);
}

TEST(Shot, AModeMayStandBesideItself) {
  const Shot shot = shot_of({"compare", "--modes", "rgb,rgb:alpha=0.5"});
  ASSERT_EQ(shot.modes.size(), 2u);
  EXPECT_EQ(shot.modes[1].name, "rgb:alpha=0.5");
  TaaSettings other = shot.modes[0].taa;
  other.alpha = 0.5f;
  EXPECT_EQ(shot.modes[1].taa, other);
}

TEST(Shot, AFileThatIsWrongIsRefused) {
  const ScratchFolder folder;
  for (const char* content : {"", "[]", "not json", R"({"alhpa": 1})", R"({"settings": {"alpha": 7}})",
                              R"({"settings": {}, "frames": 0})", R"({"settings": {}, "frames": "many"})",
                              R"({"settings": {}, "size": "0x0"})", R"({"settings": {}, "modes": [1]})"}) {
    const auto file = folder.file("wrong.json", content);
    try {
      shot_of({"compare", "--settings", file.c_str()});
      ADD_FAILURE() << content;
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.exit, Exit::input_refused) << content;
    }
  }
}

TEST(FrameInput, StartsWithACutAndFollowsTheFrameBefore) {
  const Shot shot = shot_of({"capture", "--rig", "drive", "--mode", "blend"});
  const RigContext context;
  const FrameInput first = frame_input(shot, context, shot.modes, 0),
                   fifth = frame_input(shot, context, shot.modes, 5);
  EXPECT_TRUE(first.cut);
  EXPECT_EQ(first.now.eye, first.before.eye);
  EXPECT_FALSE(fifth.cut);
  EXPECT_EQ(fifth.index, 5u);
  EXPECT_EQ(fifth.before.eye, frame_input(shot, context, shot.modes, 4).now.eye);
  EXPECT_NE(fifth.before.eye, fifth.now.eye);
}

} // namespace
} // namespace unghost
