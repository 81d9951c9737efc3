// The matrix of stiff and extreme cases in its brief form: every mode in every cell, under validation. And
// the command that prints it.
#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/measure/stability/run.h"
#include "app/paths.h"
#include "tests/app/child.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using nlohmann::json;

/// Thousands of small frames, of which the validation layer would learn nothing new.
constexpr const char* long_cases =
    "constant,thousands,bad-colour,bad-motion,bad-depth,bad-history,flat,sun,lookup";
constexpr const char* other_cases = "sizes,settings,cuts,events,chance,rest,motion";

void expect_survived(const char* cases, const char* validation) {
  const Outcome run = outcome({"stability", "--brief", "--json", "-q", "--case", cases, validation});
  ASSERT_EQ(run.exit, 0) << run.err;
  const json object = json::parse(run.out);
  size_t figures = 0;
  for (const StabilityCase& row : stability_cases())
    if (std::ranges::find(object.at("cases"), row.name, [](const json& one) { return one.at("name"); }) !=
        object.at("cases").end())
      figures += row.takers == Takers::alone ? 1 : stability_modes().size();
  EXPECT_EQ(object.at("cells").size(), figures);
  for (const json& cell : object.at("cells")) {
    EXPECT_TRUE(cell.at("pass")) << cell;
    const bool within = cell.at("value").is_number() && cell.at("value") <= cell.at("bound");
    EXPECT_TRUE(within || cell.contains("excuse")) << cell;
  }
}

TEST(StabilityMatrix, EveryModeSurvivesWhatTakesLong) { expect_survived(long_cases, "--no-validate"); }

TEST(StabilityFrames, EveryModeSurvivesWhateverIsDrawn) { expect_survived(other_cases, "--validate"); }

TEST(StabilityCells, EveryCaseIsInOneOfTheTwo) {
  const std::string both = std::string(long_cases) + "," + other_cases + ",";
  for (const StabilityCase& row : stability_cases())
    EXPECT_NE(both.find(std::string(row.name) + ","), std::string::npos) << row.name;
}

TEST(StabilityCells, AnExcuseHoldsAsFarAsItSays) {
  const StabilityCase& events =
      *std::ranges::find(stability_cases(), std::string_view("events"), &StabilityCase::name);
  const auto cell = [&](const char* mode, double figure) { return judged(events, mode, {figure, ""}); };
  EXPECT_TRUE(cell("rgb", 1).pass);
  EXPECT_FALSE(cell("rgb", 2).pass);
  EXPECT_EQ(cell("blend", 1).excuse, "") << "it needs none";
  EXPECT_TRUE(cell("blend", 8).pass) << "it may ghost";
  EXPECT_NE(cell("blend", 8).excuse, "");
  EXPECT_FALSE(cell("blend", INFINITY).pass) << "but not spread what is no number";
  EXPECT_TRUE(excuse_for("blend", "bad-colour") == nullptr);
  EXPECT_TRUE(cell("blend:alpha=0.05", 8).pass) << "a row with settings of its own has what its row may";
  EXPECT_NE(excuse_for("rgb:alpha=0.1:store=plain", "constant"), nullptr) << "and what its settings may";
  EXPECT_TRUE(excuse_for("rgb:alpha=0.1", "constant") == nullptr);
}

TEST(StabilityCells, WhatIsNoNumberIsWorst) {
  Survival survived;
  worsen(survived, 1, "here");
  worsen(survived, NAN, "there");
  worsen(survived, 2, "elsewhere");
  EXPECT_EQ(survived.where, "there");
  EXPECT_GT(survived.figure, 1e300);
}

TEST(StabilityCells, EveryAnswerThatAResolveHasIsInSomeMode) {
  const std::vector<ModeRun> modes = stability_modes();
  for (const Setting& column : settings_table()) {
    if (!column.per_mode || column.kind == SettingKind::number || column.used.holds == nullptr) continue;
    for (const Answer& answer : column.answers)
      EXPECT_TRUE(std::ranges::any_of(modes,
                                      [&](const ModeRun& run) {
                                        Settings settings;
                                        settings.taa = run.taa;
                                        return has_answer(column, settings, answer.value);
                                      }))
          << column.name << "=" << answer.name;
  }
}

TEST(StabilityCommand, OneCellByNameAndTheSameAgain) {
  const Words words = {"stability", "--brief", "--case", "chance", "--modes",
                       "rgb",       "--trial", "7",      "--json", "-q"};
  const Outcome first = outcome(words), second = outcome(words);
  ASSERT_EQ(first.exit, 0) << first.err;
  EXPECT_EQ(first.out, second.out);
  const json object = json::parse(first.out);
  ASSERT_EQ(object.at("cells").size(), 1u);
  EXPECT_EQ(object["cells"][0].at("mode"), "rgb");
  EXPECT_EQ(object["cells"][0].at("case"), "chance");
}

TEST(StabilityCommand, ARowWithASettingOfItsOwnIsAModeToo) {
  const Outcome run = outcome({"stability", "--brief", "--case", "chance", "--modes",
                               "unghost,rgb:alpha=0.3,unghost", "--trial", "7", "--json", "-q"});
  ASSERT_EQ(run.exit, 0) << run.err;
  const json cells = json::parse(run.out).at("cells");
  ASSERT_EQ(cells.size(), 2u);
  EXPECT_EQ(cells[0].at("mode"), "unghost");
  EXPECT_EQ(cells[1].at("mode"), "rgb:alpha=0.3");
}

TEST(StabilityCommand, WordsThatCannotWork) {
  EXPECT_EQ(outcome({"stability", "--brief", "--long"}).exit, 2);
  const Outcome wrong = outcome({"stability", "--case", "constnat"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_NE(wrong.err.find("did you mean 'constant'?"), std::string::npos) << wrong.err;
  EXPECT_NE(wrong.err.find("constant, bad-colour, "), std::string::npos) << wrong.err;
  const Outcome off = outcome({"stability", "--modes", "off"});
  EXPECT_EQ(off.exit, 2);
  EXPECT_NE(off.err.find("off keeps no history"), std::string::npos) << off.err;
  for (const auto& [mode, why] : {std::pair{"off:jitter=halton-8", "keeps no history"},
                                  std::pair{"rgb:blend=current", "keeps no history"},
                                  std::pair{"rgb-var:gamma=2:rectify=none", "no variance"}}) {
    const Outcome refused = outcome({"stability", "--case", "flat", "--modes", mode});
    EXPECT_EQ(refused.exit, 2) << mode;
    EXPECT_NE(refused.err.find(why), std::string::npos) << refused.err;
  }
  for (const char* trial : {"-1", "99999999999999999999", "x", ""})
    EXPECT_EQ(outcome({"stability", "--case", "chance", "--trial", trial}).exit, 2) << trial;
  for (const char* cases : {"flat", "chance,flat", "all"})
    EXPECT_EQ(outcome({"stability", "--case", cases, "--trial", "3"}).exit, 2) << cases;
  EXPECT_EQ(outcome({"stability", "--case", "flat", "-o", "table.png"}).exit, 2);
  EXPECT_EQ(outcome({"stability", "--case", "flat", "-o", "no-such-folder/table.json"}).exit, 1);
}

TEST(StabilityCommand, TheLastTrialThereIsIsDrawn) {
  const Outcome run = outcome({"stability", "--brief", "--case", "chance", "--modes", "rgb", "--trial",
                               "18446744073709551615", "--json", "-q"});
  EXPECT_EQ(run.exit, 0) << run.err;
}

TEST(StabilityCommand, AllIsEveryOne) {
  const Outcome run = outcome({"stability", "--brief", "--case", "lookup", "--modes", "all", "--json", "-q"});
  ASSERT_EQ(run.exit, 0) << run.err;
  EXPECT_EQ(json::parse(run.out).at("cells").size(), stability_modes().size());
}

TEST(StabilityCommand, ItsFileBecomesATableOfTheReport) {
  const ScratchFolder folder;
  const std::string file = (folder.path / "stability.json").string(), out = (folder.path / "page").string();
  ASSERT_EQ(
      outcome({"stability", "--brief", "--case", "flat,sun,rest", "--modes", "rgb,blend", "-q", "-o", file})
          .exit,
      0);
  const std::string results = (folder.path / "m.json").string();
  ASSERT_EQ(outcome({"measure", "--size", "32x18", "--frames", "18", "--modes", "rgb", "--what", "ghosting",
                     "-q", "-o", results})
                .exit,
            0);
  const Outcome report = outcome({"report", "--from", results, "--stability", file, "-q", "-o", out});
  ASSERT_EQ(report.exit, 0) << report.err;
  const std::string page = content_of(folder.path / "page" / "index.html");
  EXPECT_NE(page.find("id=\"stability\""), std::string::npos);
  json part = json::parse(content_of(file));
  part["cells"].erase(0);
  EXPECT_EQ(outcome({"report", "--from", results, "--stability",
                     folder.file("part.json", part.dump()).string(), "-q", "-o", out})
                .exit,
            0);
  EXPECT_NE(content_of(folder.path / "page" / "index.html").find("1 are missing"), std::string::npos);
  const std::string broken = folder.file("broken.json", "{\"cells\": []}").string();
  const Outcome refused = outcome({"report", "--from", results, "--stability", broken, "-q", "-o", out});
  EXPECT_EQ(refused.exit, 3);
  EXPECT_NE(refused.err.find("broken.json holds no matrix"), std::string::npos) << refused.err;
}

} // namespace
} // namespace unghost
