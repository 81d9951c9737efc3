#include "renderer/settings.h"

#include <clocale>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "renderer/mode_names.h"

namespace unghost {
namespace {

std::string complaint(auto&& act) {
  try {
    act();
  } catch (const SettingError& error) {
    return error.what();
  }
  return {};
}

// A text that the row accepts and that is not its default.
std::string another_value(const Setting& row) {
  if (row.kind != SettingKind::number) return row.answers.back().name;
  Settings settings;
  row.write(settings, row.low + (row.high - row.low) * 0.37f);
  return row.get(settings);
}

TEST(Settings, NamesAreUniqueAndKebabCase) {
  std::set<std::string_view> seen;
  for (const Setting& row : settings_table()) {
    EXPECT_TRUE(seen.insert(row.name).second) << row.name;
    EXPECT_EQ(row.name.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), row.name.npos) << row.name;
    EXPECT_TRUE(row.summary.ends_with('.')) << row.name;
  }
}

TEST(Settings, EveryRowSetsItsOwnValueAndNoOther) {
  for (const Setting& row : settings_table()) {
    Settings settings;
    const std::string value = another_value(row);
    ASSERT_NE(value, row.get(Settings{})) << row.name;
    apply_setting(settings, std::string(row.name) + "=" + value);
    for (const Setting& other : settings_table())
      EXPECT_EQ(other.get(settings), &other == &row ? value : other.get(Settings{}))
          << row.name << " " << other.name;
  }
}

TEST(Settings, DefaultsLieInTheirRanges) {
  for (const Setting& row : settings_table()) {
    Settings settings;
    EXPECT_NO_THROW(row.set(settings, row.get(settings))) << row.name;
  }
}

TEST(Settings, JsonReadsBackToTheSameBits) {
  Settings settings;
  for (const Setting& row : settings_table()) row.set(settings, another_value(row));
  settings.taa.alpha = 0.1f + 1e-8f;
  settings.light.exposure_ev = -1.0f / 3;
  Settings read;
  apply_settings_json(read, nlohmann::json::parse(settings_json(settings).dump()));
  for (const Setting& row : settings_table()) EXPECT_EQ(row.read(read), row.read(settings)) << row.name;
}

TEST(Settings, JsonWritesShortNumbers) { EXPECT_EQ(settings_json(Settings{})["alpha"].dump(), "0.1"); }

TEST(Settings, PartsOfJsonShareNothingAndMissNothing) {
  const auto shared = settings_json(Settings{}, SettingsPart::shared);
  const auto per_mode = settings_json(Settings{}, SettingsPart::per_mode);
  EXPECT_EQ(shared.size() + per_mode.size(), settings_table().size());
  EXPECT_TRUE(per_mode.contains("alpha") && per_mode.contains("reject"));
  EXPECT_TRUE(shared.contains("sun") && shared.contains("view"));
}

TEST(Settings, FlagsAreAListOrNothing) {
  Settings settings;
  apply_setting(settings, "reject=tag,off-screen");
  EXPECT_EQ(settings.taa.policy.reject, Reject::off_screen | Reject::tag);
  EXPECT_EQ(find_setting("reject").get(settings), "off-screen,tag");
  apply_setting(settings, "reject=nothing");
  EXPECT_EQ(settings.taa.policy.reject, Reject::nothing);
  EXPECT_NE(complaint([&] { apply_setting(settings, "reject=tag,"); }), "");
}

TEST(Settings, WrongWordsNameTheNearest) {
  Settings settings;
  EXPECT_NE(complaint([&] { apply_setting(settings, "alhpa=0.1"); }).find("'alpha'"), std::string::npos);
  EXPECT_NE(complaint([&] { apply_setting(settings, "rectify=box-clmp"); }).find("did you mean 'box-clamp'"),
            std::string::npos);
  EXPECT_NE(complaint([&] { settings_for_mode("unchartd"); }).find("'uncharted'"), std::string::npos);
  EXPECT_NE(complaint([&] { apply_setting(settings, "alpha"); }).find("name=value"), std::string::npos);
}

TEST(Settings, AModeMayHaveSettingsOfItsOwn) {
  const ModeRun run = mode_run("grand-tour:alpha=0.25:reject=off-screen+tag");
  EXPECT_EQ(run.name, "grand-tour:alpha=0.25:reject=off-screen+tag");
  TaaSettings uncharted = settings_for_mode("uncharted").taa;
  uncharted.alpha = 0.25f;
  EXPECT_EQ(run.taa, uncharted);
  EXPECT_EQ(mode_run("rgb").taa, settings_for_mode("rgb").taa);
  for (const auto& [text, why] : {std::pair{"rbg:alpha=0.2", "'rgb'"},
                                  {"rgb:alhpa=0.2", "'alpha'"},
                                  {"rgb:alpha=2", "from 0 to 1"},
                                  {"rgb:", "name=value"},
                                  {"rgb:alpha=0.2:", "name=value"},
                                  {"rgb:sun=0.2", "not a mode's own"},
                                  {"rgb:gamma=2", "gamma has no effect"},
                                  {"rgb:alpha=0.2:alpha=0.3", "alpha more than once"}})
    EXPECT_NE(complaint([&] { mode_run(text); }).find(why), std::string::npos) << text;
}

TEST(Settings, NamesOfModesAreTakenApart) {
  EXPECT_EQ(base_of_mode("rgb"), "rgb");
  EXPECT_TRUE(changes_of_mode("rgb").empty());
  EXPECT_EQ(base_of_mode("rgb:alpha=0.05:reject=tag+depth"), "rgb");
  EXPECT_EQ(changes_of_mode("rgb:alpha=0.05:reject=tag+depth"),
            (std::vector<std::string>{"alpha=0.05", "reject=tag,depth"}));
  EXPECT_EQ(changes_of_mode("rgb:"), std::vector<std::string>{""});
  EXPECT_TRUE(mode_says("rgb:jitter-scale=0.5", "jitter-scale"));
  EXPECT_FALSE(mode_says("rgb:jitter-scale=0.5", "jitter"));
}

TEST(Settings, NumbersOutsideTheirRangeAreRefused) {
  for (const char* text : {"alpha=1.01", "alpha=-0.1", "alpha=nan", "alpha=inf", "alpha=", "alpha=0.1x",
                           "alpha=0,1", "alpha= 0.1", "alpha=1e99", "speed=-1"}) {
    Settings settings;
    EXPECT_NE(complaint([&] { apply_setting(settings, text); }).find("is a number from 0 to"),
              std::string::npos)
        << text;
  }
}

TEST(Settings, JsonOfAWrongTypeIsRefused) {
  Settings settings;
  EXPECT_THROW(apply_settings_json(settings, {{"alpha", true}}), SettingError);
  EXPECT_THROW(apply_settings_json(settings, {{"alpha", nlohmann::json::array()}}), SettingError);
  EXPECT_THROW(apply_settings_json(settings, {{"unknown", 1}}), SettingError);
  EXPECT_THROW(apply_settings_json(settings, nlohmann::json::array()), SettingError);
}

TEST(Settings, NumbersDoNotDependOnTheLocale) {
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8")) GTEST_SKIP() << "no locale with a decimal comma";
  Settings settings;
  apply_setting(settings, "alpha=0.25");
  EXPECT_EQ(find_setting("alpha").get(settings), "0.25");
  std::setlocale(LC_ALL, "C");
}

TEST(Settings, EveryModeIsRefusedNothing) {
  for (const TaaMode& mode : taa_modes())
    EXPECT_EQ(refusal(settings_for_mode(mode.name)), std::nullopt) << mode.name;
}

TEST(Settings, CombinationsThatMakeNoSenseAreRefused) {
  Settings settings = settings_for_mode("grand-tour");
  settings.taa.near_m = settings.taa.far_m = 8;
  EXPECT_NE(refusal(settings).value_or("").find("less than far"), std::string::npos);
  settings = settings_for_mode("dop16-opt");
  settings.taa.policy.space = Space::ycocg;
  EXPECT_NE(refusal(settings).value_or("").find("were found for linear RGB"), std::string::npos);
  settings = settings_for_mode("ac4");
  settings.taa.policy.blend = Blend::counting;
  EXPECT_NE(refusal(settings).value_or("").find("keeps=input"), std::string::npos);
  settings = settings_for_mode("off");
  settings.taa.policy.history = HistoryFilter::catmull_rom;
  EXPECT_NE(refusal(settings).value_or("").find("blend=current keeps no history"), std::string::npos);
  settings = settings_for_mode("off");
  settings.taa.texture_jitter = TextureJitter::removed;
  EXPECT_NE(refusal(settings).value_or("").find("texture-jitter=removed has no effect: jitter=none"),
            std::string::npos);
}

TEST(Spelling, ComesFromTheEnumerators) {
  EXPECT_EQ(spelling(Jitter::halton_8), "halton-8");
  EXPECT_EQ(spelling(Dilation::closest_depth), "closest-depth");
  EXPECT_EQ(spelling(View::tag_rejected), "tag-rejected");
  EXPECT_EQ(spelling(Jitter(77)), "");
  for (const Answer& answer : answers<View>()) EXPECT_EQ(spelling(View(answer.value)), answer.name);
}

TEST(Spelling, NearestWordIsNearOrNone) {
  const std::vector<std::string> known = {"capture", "compare", "measure"};
  EXPECT_EQ(nearest_word("captur", known), "capture");
  EXPECT_EQ(nearest_word("comprae", known), "compare");
  EXPECT_EQ(nearest_word("zebra", known), "");
  EXPECT_EQ(nearest_word("x", known), "");
  EXPECT_EQ(did_you_mean("zebra", known), "; there are capture, compare, measure");
  EXPECT_EQ(did_you_mean("zebra", std::vector<std::string>(40, "word")), "");
}

} // namespace
} // namespace unghost
