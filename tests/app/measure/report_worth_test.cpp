// What the report says is worth having, and what has changed: decided by what can be read and told apart.
#include <set>

#include <gtest/gtest.h>

#include "app/measure/report/case_charts.h"
#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"
#include "tests/app/report_sample.h"

namespace unghost {
namespace {

class ReportWorth : public testing::Test {
protected:
  ReportSample sample{{"pass"}};
  Measured& m = sample.results.scenes.front();

  double& figure(const char* mode, const char* name) {
    return std::ranges::find(m.rows, mode, &MeasuredMode::mode)->figures[name];
  }
  std::vector<std::string> front(const char* name) const {
    std::vector<std::string> modes;
    for (const size_t i : front_of(m, *std::ranges::find(figure_kinds(), name, &FigureKind::name)))
      modes.push_back(m.rows[i].mode);
    return modes;
  }
  bool is_on_front(const char* mode, const char* name) const {
    return std::ranges::count(front(name), mode) > 0;
  }
  std::string page(const PageNotes& notes = {}) const {
    return report_page(sample.results, ReportSample::picture, notes);
  }
};

TEST_F(ReportWorth, WhatReadsAlikeIsEqual) {
  figure("uncharted", "added_ms") = .1, figure("grand-tour", "added_ms") = .2;
  figure("uncharted", "error") = .01004, figure("grand-tour", "error") = .01001; // both .0100
  EXPECT_TRUE(is_on_front("uncharted", "error"));
  EXPECT_FALSE(is_on_front("grand-tour", "error"));
  figure("grand-tour", "error") = .0099;
  EXPECT_TRUE(is_on_front("grand-tour", "error"));
}

TEST_F(ReportWorth, TimesThatTheRoundsDoNotTellApartAreEqual) {
  const auto takes = [&](const char* mode, double ms, double spread) {
    figure(mode, "added_ms") = ms, figure(mode, "p05") = ms - spread, figure(mode, "p95") = ms + spread;
  };
  figure("uncharted", "error") = .011, figure("grand-tour", "error") = .010;
  takes("uncharted", .100, .001), takes("grand-tour", .102, .001);
  EXPECT_TRUE(is_on_front("uncharted", "error"));
  takes("uncharted", .100, .050), takes("grand-tour", .102, .050);
  EXPECT_FALSE(is_on_front("uncharted", "error")) << "no cheaper for all that is known, and worse";
}

TEST_F(ReportWorth, NothingGhostsWhereNothingMoves) {
  figure("gdk-variance", "ghosting") = .0183;
  EXPECT_FALSE(front("ghosting").empty());
  EXPECT_EQ(page().find("Nothing moves here"), std::string::npos);
  m.rig = rest_rig;
  EXPECT_TRUE(front("ghosting").empty());
  EXPECT_FALSE(front("shimmer").empty());
  for (const FigureKind* kind : errors_in(m)) EXPECT_NE(kind->name, "ghosting");
  EXPECT_NE(page().find("Nothing moves here"), std::string::npos);
}

TEST_F(ReportWorth, TheAliasedFrameIsSaidToBeNearestWhereItIs) {
  EXPECT_EQ(page().find("No mode is as near"), std::string::npos);
  figure("off", "error") = .00101;
  EXPECT_NE(page().find("as the aliased one: 0.0010;"), std::string::npos);
  figure("rgb", "error") = .00099; // reads alike
  EXPECT_EQ(page().find("No mode is as near"), std::string::npos);
}

TEST_F(ReportWorth, WhatReadsAsTheBestIsOutlined) {
  for (MeasuredMode& row : m.rows) row.figures["error"] = .05;
  figure("rgb", "error") = .01004, figure("ycocg", "error") = .01001;
  const std::string table = modes_table(m, looks_of(sample.results)), best = "best\">0.0100<";
  const size_t first = table.find(best);
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(table.find(best, first + 1), std::string::npos);
}

TEST_F(ReportWorth, AModeLooksTheSameInEveryReport) {
  const Looks all = looks_of(sample.results);
  Results one;
  one.scenes = {m};
  std::erase_if(one.scenes[0].modes, [](const auto& mode) { return mode.first != "dop16-opt"; });
  const Looks alone = looks_of(one);
  ASSERT_EQ(alone.size(), 1u);
  EXPECT_EQ(alone.at("dop16-opt").shape, all.at("dop16-opt").shape);
  EXPECT_EQ(alone.at("dop16-opt").family, all.at("dop16-opt").family);
  std::set<std::pair<int, int>> seen;
  for (const auto& [mode, look] : all) EXPECT_TRUE(seen.insert({look.family, look.shape}).second) << mode;
}

TEST_F(ReportWorth, ChangesSinceABaselineAreOnThePage) {
  BaselineComparison comparison{
      .allowed_share = .05, .changes = {}, .missing = {"<b>: is not in the baseline"}};
  const auto change = [&](const char* mode, Verdict verdict, bool regression) {
    comparison.changes.push_back({.scene = "asphalt", .rig = "pass", .mode = mode, .figure = "ghosting"});
    comparison.changes.back().verdict = verdict, comparison.changes.back().regression = regression;
  };
  change("rgb", Verdict::noise, false), change("ycocg", Verdict::better, false);
  change("blend", Verdict::worse, true), change("uncharted", Verdict::same, false);
  const std::string html = baseline_section({"<old>.json", comparison}, looks_of(sample.results));
  EXPECT_NE(html.find("Since &lt;old&gt;.json"), std::string::npos);
  EXPECT_NE(html.find("Of 4 figures 2 have changed, 1 differ"), std::string::npos) << html;
  EXPECT_NE(html.find("&lt;b&gt;: is not"), std::string::npos);
  const size_t worse = html.find("blend<"), better = html.find("ycocg<"), noise = html.find("rgb<");
  EXPECT_TRUE(worse < better && better < html.find("<details>") && html.find("<details>") < noise) << html;
  EXPECT_EQ(html.find("uncharted<"), std::string::npos);
  EXPECT_EQ(page().find("id=\"baseline\""), std::string::npos);
  EXPECT_NE(page({.paragraphs = {}, .baseline = Baseline{"old.json", comparison}}).find("id=\"baseline\""),
            std::string::npos);
}

} // namespace
} // namespace unghost
