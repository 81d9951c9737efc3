#include "app/run.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/demo/actions.h"
#include "app/rigs.h"
#include "renderer/settings.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

bool has_line_count(const std::string& text, long count) { return std::ranges::count(text, '\n') == count; }

TEST(Run, HelpSaysCommandsAndExitCodes) {
  const Outcome help = outcome({"--help"});
  EXPECT_EQ(help.exit, 0);
  EXPECT_EQ(help.err, "");
  for (const CommandRow& row : commands()) EXPECT_NE(help.out.find(row.name), std::string::npos) << row.name;
  for (const char* words : {"2 the words were wrong", "4 no usable Vulkan device", "130 and 143"})
    EXPECT_NE(help.out.find(words), std::string::npos) << words;
  for (const CommandRow& row : commands()) {
    const Outcome own = outcome(std::vector<std::string>{std::string(row.name), "-h"});
    EXPECT_EQ(own.exit, 0) << row.name;
    EXPECT_NE(own.out.find("--json"), std::string::npos) << row.name;
  }
}

TEST(Run, NoWordsWithoutADisplayAreHelpOnErrAndTwo) {
  unsetenv("DISPLAY"), unsetenv("WAYLAND_DISPLAY");
  const Outcome nothing = outcome({});
  EXPECT_EQ(nothing.exit, 2);
  EXPECT_EQ(nothing.out, "");
  EXPECT_NE(nothing.err.find("capture"), std::string::npos);
}

TEST(Run, WordsWithoutACommandAreTheDemo) {
  for (const Words& words : {Words{"car.glb"}, Words{"--mode", "blend"}, Words{"demo", "car.gltf"}})
    EXPECT_EQ(command_line_of(words).command->name, default_command) << words[0];
}

TEST(Run, WithoutADisplayTheDemoIsOneAndSaysWhatIsThere) {
  unsetenv("DISPLAY"), unsetenv("WAYLAND_DISPLAY");
  const Outcome run = outcome({"demo"});
  EXPECT_EQ(run.exit, 1);
  EXPECT_NE(run.err.find("cannot open a window"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("unghost capture"), std::string::npos) << run.err;
}

TEST(Run, WrongWordsAreTwoAndOneSentence) {
  const std::vector<std::pair<std::vector<std::string>, const char*>> cases = {
      {{"captur"}, "did you mean 'capture'?"},
      {{"capture", "--farmes", "3"}, "did you mean '--frames'?"},
      {{"capture", "--farmes=3"}, "no option '--farmes'"},
      {{"capture", "a.glb", "b.glb"}, "'b.glb' is one word too many"},
      {{"capture"}, "capture wants -o"},
      {{"compare"}, "compare wants -o"},
      {{"capture", "-o", "a.jpg"}, ".png or .exr"},
      {{"capture", "-o", "-", "--json"}, "standard output"},
      {{"capture", "-o", "a.png", "--frames", "0"}, "--frames"},
      {{"capture", "-o", "a.png", "--frames", "x"}, "--frames"},
      {{"capture", "-o", "a.png", "--size", "64"}, "WIDTHxHEIGHT"},
      {{"capture", "-o", "a.png", "--size", "0x4"}, "WIDTHxHEIGHT"},
      {{"capture", "-o", "a.png", "--size", "4x4x"}, "WIDTHxHEIGHT"},
      {{"capture", "-o", "a.png", "--size", "99999x1"}, "WIDTHxHEIGHT"},
      {{"capture", "-o", "a.png", "--seed", "-1"}, "a seed is"},
      {{"capture", "-o", "a.png", "--seed", "99999999999999999999999"}, "a seed is"},
      {{"capture", "-o", "a.png", "--rig", "zzz"}, "there are still, drive"},
      {{"capture", "-o", "a.png", "--rig", "rotat"}, "'rotate'"},
      {{"capture", "-o", "a.png", "--mode", "blnd"}, "'blend'"},
      {{"capture", "-o", "a.png", "--view", "taag"}, "'tag'"},
      {{"capture", "-o", "a.png", "--set", "alpha=2"}, "from 0 to 1"},
      {{"capture", "-o", "a.png", "--set", "alfa=0"}, "'alpha'"},
      {{"capture", "-o", "a.png", "--from", "3"}, "--sequence"},
      {{"capture", "--sequence", "s", "--from", "64"}, "beyond the last"},
      {{"capture", "-o", "a.exr", "--view", "tag"}, "EXR"},
      {{"compare", "-o", "a.exr"}, "PNG"},
      {{"compare", "-o", "a.png", "--mode", "blend"}, "'--modes'"},
      {{"measure", "--what", "trial"}, "'trail'"},
      {{"measure", "--frames", "17"}, "--frames"},
      {{"measure", "--protocol", "slow"}, "slow not in {quick,full}"},
      {{"measure", "--keep", "best", "-o", "a.json"}, "best not in {none,worst,all}"},
      {{"measure", "--keep", "all"}, "--keep wants -o FILE.json"},
      {{"measure", "-o", "a.csv"}, ".json file"},
      {{"measure", "--set", "jitter=halton-8"}, "the same ten points of R2"},
      {{"measure", "--view", "motion"}, "--view has no place"},
      {{"measure", "--rounds", "3"}, "--rounds are for --what time"},
      {{"measure", "--what", "time", "--set", "resolver=naive"}, "resolver is not for it"},
      {{"bench", "--set", "jitter-scale=0.5"}, "without jitter"},
      {{"report"}, "report wants -o FOLDER"},
      {{"report", "-o", "r", "--quick", "--full"}, "do not go together"},
      {{"report", "-o", "r", "--allow", "0.1"}, "--baseline"},
      {{"report", "-o", "r", "--allow", "nan", "--baseline", "a.json"}, "a number from 0 to 100"},
      {{"report", "-o", "r", "--from", "a", "--rig", "drive"}, "nothing to choose"},
      {{"report", "-o", "r", "--modes", "blnd"}, "'blend'"},
      {{"report", "-o", "r", "--set", "jitter=halton-8"}, "the same ten points of R2"},
      {{"modes", "--size", "4x4"}, "--size"},
      {{"axes", "--faces", "9"}, "--faces must be even"},
      {{"axes", "--faces", "6"}, "must be more than 6"},
      {{"bench", "--set", "resolver=naive"}, "both resolvers"},
      {{"capture", "-o", "a.png", "--mode", "blend", "--set", "blend=attenuated"}, "rectify=none"},
      {{"capture", "-o", "a.png", "--mode", "dop16-opt", "--set", "space=ycocg"}, "linear RGB"},
      {{"capture", "-o", "a.png", "--mode", "dop16-opt", "--set", "weighting=log"}, "linear RGB"},
      {{"capture", "-o"}, "--output wants a value"},
      {{"capture", "-o", "a.png", "-o", "b.png"}, "--output takes one value"},
      {{"capture", "--set", "-o", "a.png"}, "--set: a value is missing"},
      {{"compare", "--modes", ",", "-o", "a.png"}, "--modes: a value is missing"},
      {{"compare", "--modes", "blend,blend", "-o", "a.png"}, "blend more than once"},
      {{"compare", "--modes", "all,off", "-o", "a.png"}, "off more than once"},
      {{"capture", "-q", "-v", "-o", "a.png"}, "do not go together"},
      {{"capture", "", "-o", "a.png"}, "name is empty"},
      {{"capture", "--set", "reject=nothing,tag", "-o", "a.png"}, "stands alone"},
  };
  for (const auto& [words, expected] : cases) {
    const Outcome wrong = outcome(words);
    EXPECT_EQ(wrong.exit, 2) << expected << ": " << wrong.err;
    EXPECT_EQ(wrong.out, "") << expected;
    EXPECT_NE(wrong.err.find(expected), std::string::npos) << wrong.err;
    EXPECT_TRUE(has_line_count(wrong.err, 1)) << wrong.err;
  }
}

TEST(Run, OutputThatCannotBeWrittenIsOne) {
  struct Full : std::streambuf {
    int overflow(int) override { return traits_type::eof(); }
  };
  struct FullAtTheEnd : std::stringbuf {
    int sync() override { return -1; }
  };
  Full full;
  FullAtTheEnd full_at_the_end;
  for (std::streambuf* buffer : std::initializer_list<std::streambuf*>{&full, &full_at_the_end})
    for (const char* word : {"modes", "--help", "--version"}) {
      std::ostream out(buffer);
      std::ostringstream err;
      EXPECT_EQ(run(std::vector{word}, out, err), 1) << word;
      EXPECT_EQ(err.str(), "unghost: cannot write to standard output\n") << word;
    }
}

TEST(Run, AFolderThatIsNotThereIsOneBeforeAnythingIsDrawn) {
  const Outcome nowhere = outcome({"capture", "-o", "/nowhere/at/all/a.png"});
  EXPECT_EQ(nowhere.exit, 1);
  EXPECT_NE(nowhere.err.find("there is no folder /nowhere/at/all"), std::string::npos) << nowhere.err;
}

TEST(Run, ASettingsFileThatIsWrongIsThree) {
  const ScratchFolder folder;
  const std::string file = folder.file("a.json", "{").string();
  EXPECT_EQ(outcome({"capture", "-o", "a.png", "--settings", file.c_str()}).exit, 3);
  EXPECT_EQ(outcome({"capture", "-o", "a.png", "--settings", "/nowhere.json"}).exit, 3);
}

TEST(Run, ListsAreTablesOrJsonOfTheSame) {
  const auto names = [](const std::string& command, const char* key) {
    const Outcome table = outcome({command}), json = outcome(std::vector<std::string>{command, "--json"});
    EXPECT_EQ(table.exit, 0);
    EXPECT_EQ(json.err, "");
    std::vector<std::string> found;
    const auto all = nlohmann::json::parse(json.out);
    for (const auto& each : all.at(key)) {
      found.push_back(each.at("name"));
      EXPECT_NE(table.out.find(found.back()), std::string::npos) << found.back();
    }
    return found;
  };
  EXPECT_EQ(names("modes", "modes").size(), taa_modes().size());
  EXPECT_EQ(names("rigs", "rigs").size(), rigs().size());
  EXPECT_EQ(names("views", "views").size(), answers<View>().size());
  EXPECT_EQ(names("settings", "settings").size(), settings_table().size());
  EXPECT_EQ(outcome(std::vector<std::string>{"modes", "--no-json"}).out, outcome({"modes"}).out);
}

TEST(Run, ViewsSayWhatTheyShow) {
  const auto views =
      nlohmann::json::parse(outcome(std::vector<std::string>{"views", "--json"}).out).at("views");
  for (const auto& view : views)
    EXPECT_TRUE(view.at("summary").get<std::string>().ends_with('.')) << view.at("name");
}

TEST(Run, TheReadmesTableHasTheRowsOfTheModes) {
  std::ifstream readme(UNGHOST_README);
  std::vector<std::string> listed, rows;
  bool in_table = false;
  for (std::string line; std::getline(readme, line);) {
    in_table = line.starts_with("| mode |") || (in_table && line.starts_with('|'));
    if (in_table && line.starts_with("| `")) listed.push_back(line.substr(3, line.find('`', 3) - 3));
  }
  for (const TaaMode& mode : taa_modes()) rows.emplace_back(mode.name);
  EXPECT_EQ(listed, rows);
}

TEST(Run, TheReadmesControlsAreThoseOfTheDemo) {
  std::ifstream readme(UNGHOST_README);
  const std::string text{std::istreambuf_iterator<char>(readme), {}};
  for (const Action& action : actions()) {
    const std::string row =
        "| " + key_text(action) + " | " + std::string(button_text(action)) + " | " + action.what + " |";
    if (std::isdigit(uint8_t(key_text(action)[0])) == 0) { // digits have one row in all
      EXPECT_NE(text.find(row), std::string::npos) << row;
    }
  }
}

TEST(Run, ModesSayTheirSettings) {
  const auto modes =
      nlohmann::json::parse(outcome(std::vector<std::string>{"modes", "--json"}).out).at("modes");
  for (const auto& mode : modes) {
    Settings settings;
    apply_settings_json(settings, mode.at("settings"));
    EXPECT_EQ(settings.taa, settings_for_mode(mode.at("name").get<std::string>()).taa);
  }
}

} // namespace
} // namespace unghost
