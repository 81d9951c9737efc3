// The report as text: what is in it, what is not, and that nothing in it can do harm.
#include "app/measure/report/report_page.h"

#include <gtest/gtest.h>

#include "app/measure/report/case_charts.h"
#include "app/measure/report/embedded.h"
#include "app/measure/report/html.h"
#include "renderer/gpu/sha256.h"
#include "tests/app/report_sample.h"

namespace unghost {
namespace {

std::string page_of(const Results& results, const PageNotes& notes = {}) {
  return report_page(results, ReportSample::picture, notes);
}

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++found;
  return found;
}

/// From the first `begin` to the next `end`; empty where there is none.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const size_t from = text.find(begin);
  if (from == std::string::npos) return {};
  return text.substr(from + begin.size(), text.find(end, from + begin.size()) - from - begin.size());
}

std::vector<std::string> blocks(const std::string& page, const std::string& element) {
  std::vector<std::string> found;
  const std::string begin = "<" + element + ">", end = "</" + element + ">";
  for (size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at)) {
    at += begin.size();
    found.push_back(page.substr(at, page.find(end, at) - at));
  }
  return found;
}

TEST(ReportPage, TheHashOfTheTestIsTheStandards) {
  EXPECT_EQ(Sha256::hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(ReportPage, ItsPolicyAllowsWhatIsInlineAndNothingElse) {
  const std::string page = page_of(ReportSample({"pass"}).results);
  const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
  EXPECT_TRUE(policy.starts_with("default-src 'none'; img-src data:; style-src 'sha256-")) << policy;
  EXPECT_EQ(policy.find("unsafe"), std::string::npos);
  const std::vector<std::string> styles = blocks(page, "style"), scripts = blocks(page, "script");
  EXPECT_EQ(styles.size(), 1u);
  EXPECT_EQ(scripts.size(), report_files::chart_js.text.empty() ? 2u : 4u);
  EXPECT_EQ(count(policy, "'sha256-"), styles.size() + scripts.size());
  for (const auto& block : {styles, scripts})
    for (const std::string& text : block)
      EXPECT_NE(policy.find(csp_hash(Sha256::hex(text))), std::string::npos) << text.substr(0, 60);
  // what the policy would stop anyway: attributes that are code or style, and addresses to load from
  std::string markup = page;
  for (const std::string& script : scripts) markup.erase(markup.find(script), script.size());
  for (size_t at = markup.find("=\""); at != std::string::npos; at = markup.find("=\"", at + 1)) {
    const size_t space = markup.find_last_of(" \n", at);
    const std::string attribute = markup.substr(space + 1, at - space - 1);
    EXPECT_TRUE(attribute != "style" && !attribute.starts_with("on")) << markup.substr(space, 80);
  }
  EXPECT_EQ(markup.find("http://"), std::string::npos);
  EXPECT_EQ(markup.find("https://"), std::string::npos);
}

TEST(ReportPage, NamesFromFilesAreText) {
  const std::string evil = "<img src=x onerror=\"alert('1')\"></script><!--&";
  ReportSample sample({"pass"});
  Measured& m = sample.results.scenes.front();
  m.scene = m.device = m.driver = m.build = m.version = m.timing->host = sample.results.protocol = evil;
  m.rig = m.modes[1].first = m.rows[1].mode = m.kept[1].mode = m.kept[2].mode = evil;
  m.modes[1].second["jitter"] = evil, m.modes[1].second[evil] = evil;
  m.settings[evil] = {{evil, evil}}, m.set = {evil};
  m.convergence->curves[0].name = m.convergence->curves.back().name = evil;
  for (KeptFrame& kept : m.kept) kept.picture = kept.reference = evil;
  const std::string page = page_of(sample.results, {{evil}});
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_EQ(page.find("onerror=\""), std::string::npos);
  EXPECT_EQ(page.find("<!--"), std::string::npos);
  EXPECT_EQ(count(page, "</script>"), count(page, "<script"));
  EXPECT_NE(page.find(escaped(evil)), std::string::npos);
  EXPECT_NO_THROW(nlohmann::json::parse(between(page, "id=\"data\">", "</script>")));
}

TEST(ReportPage, AChartHasAPointForEachModeWithThatFigure) {
  ReportSample sample({"pass"});
  Measured& m = sample.results.scenes.front();
  m.rows[3].figures.erase("error");
  m.rows[4].figures.erase("added_ms");
  const std::string page = page_of(sample.results);
  const auto data = nlohmann::json::parse(between(page, "id=\"data\">", "</script>")).at("charts");
  const size_t timed = taa_modes().size() - 1; // without the one above
  for (const auto& [figure, points] : std::map<std::string, size_t>{{"error", timed - 1},
                                                                    {"ghosting", timed},
                                                                    {"shimmer", timed},
                                                                    {"flicker", timed},
                                                                    {"trail", timed}}) {
    const std::string id = "case-1-" + figure;
    const std::string chart = between(page, "id=\"" + id + "\"", "</figure>");
    EXPECT_EQ(count(chart, "<svg class=\"chart\""), 1u) << figure;
    EXPECT_EQ(count(chart, "<g class=\"series f"), points) << figure;
    EXPECT_EQ(count(chart, "class=\"front\""), 1u) << figure;
    const auto& series = data.at(id).at("series");
    EXPECT_EQ(std::ranges::count_if(series, [](const auto& s) { return s.at("mark") == "point"; }),
              std::ptrdiff_t(points));
    const bool beaten = figure != "ghosting" && figure != "trail"; // by supersampling, where it was measured
    EXPECT_EQ(count(chart, "class=\"reference\""), beaten ? 1u : 0u) << figure;
  }
}

TEST(ReportPage, NoModeIsOnAFrontForDoingNothing) {
  ReportSample sample({"pass"});
  const Measured& m = sample.results.scenes.front();
  const auto first = [&](const char* figure) {
    const auto kind = std::ranges::find(figure_kinds(), figure, &FigureKind::name);
    return m.rows[front_of(m, *kind).front()].mode;
  };
  EXPECT_EQ(first("error"), "off");
  EXPECT_NE(first("ghosting"), "off"); // of which it has none by definition
  EXPECT_NE(first("trail"), "off");
}

TEST(ReportPage, TheTableMarksTheBestOfEachColumn) {
  ReportSample sample({"pass"});
  Measured& m = sample.results.scenes.front();
  m.rows[5].figures["error"] = 0.00125;
  const std::string table = between(page_of(sample.results), "<table class=\"modes sortable\"", "</table>");
  EXPECT_NE(table.find("<strong class=\"best\">0.0013<"), std::string::npos); // or 0.0012: a tie of rounding
  EXPECT_EQ(count(table, "class=\"best\""), 10u);
  EXPECT_EQ(count(table, "<tr data-mode="), m.rows.size());
}

TEST(ReportPage, WhatWasNotMeasuredIsNotThere) {
  ReportSample sample({"pass", "drive"});
  const std::string whole = page_of(sample.results);
  for (const char* part :
       {"Work and precision", "Convergence of the modes", "Convergence of the jitter", "Run time</strong>",
        "Trail</strong>", "The worst frames", "The same instant", "Table 2, asphalt", "class=\"cases\""})
    EXPECT_NE(whole.find(part), std::string::npos) << part;
  EXPECT_EQ(whole.find("Table 1, grass"), std::string::npos); // no such scene

  sample.results.scenes.pop_back();
  Measured& m = sample.results.scenes.front();
  m.rig = "still", m.timing.reset(), m.convergence.reset(), m.kept.clear(), m.supersampled.clear();
  for (MeasuredMode& row : m.rows)
    row.samples.clear(), row.figures = {{"shimmer", row.figures.at("shimmer")}};
  const std::string bare = page_of(sample.results);
  for (const char* part : {"Work and precision", "Convergence of", "Run time</strong>", "Trail</strong>",
                           "The worst frames", "The same instant", "Table 2, asphalt", "class=\"cases\""})
    EXPECT_EQ(bare.find(part), std::string::npos) << part;
  EXPECT_NE(bare.find("No mode has both a time and an error"), std::string::npos);
  EXPECT_NE(bare.find("Its rows were not measured"), std::string::npos);
  EXPECT_NE(page_of({}).find("Nothing was measured."), std::string::npos);
}

TEST(ReportPage, PicturesThatAreNotThereAreLeftOut) {
  const Results results = ReportSample({"pass"}).results;
  const std::string page = report_page(results, [](const auto&, const auto&) { return std::nullopt; }, {});
  EXPECT_EQ(page.find("<img"), std::string::npos);
  EXPECT_EQ(page.find("The worst frames"), std::string::npos);
  EXPECT_NE(page_of(results).find("<img"), std::string::npos);
}

TEST(ReportPage, ALargePictureIsCutToWhereItIsWorst) {
  ReportSample sample({"pass"});
  Measured& m = sample.results.scenes.front();
  std::erase_if(m.kept,
                [](const KeptFrame& kept) { return kept.kind != "ghosting" || kept.mode != "blend"; });
  ASSERT_EQ(m.kept.size(), 1u);
  const auto large = [](const KeptFrame&, const std::string& file) {
    Image image{
        .name = {}, .width = 960, .height = 540, .rgba = std::vector<uint8_t>(size_t(960) * 540 * 4, 100)};
    if (file != "off.png")
      for (uint32_t y = 500; y < 530; ++y)
        for (uint32_t x = 900; x < 940; ++x) image.rgba[(size_t(y) * 960 + x) * 4] = 255;
    return std::optional(image);
  };
  const std::string page = report_page(sample.results, large, {});
  const std::string note = between(page, "The 640x360 pixels with the most error, from ", ".");
  EXPECT_TRUE(note.ends_with(" of 960x540")) << note;
  const int x = std::stoi(note), y = std::stoi(note.substr(note.find(", ") + 2));
  EXPECT_TRUE(x + 640 >= 940 && x <= 320 && y + 360 >= 530 && y <= 180) << note;
  EXPECT_EQ(count(page, "width=\"640\" height=\"360\" alt="), 3u);
}

TEST(ReportPage, ThePapersOrderIsComparedAndExplained) {
  ReportSample sample({"drive"});
  Measured& m = sample.results.scenes.front();
  const auto set = [&](const char* mode, double ghosting) {
    std::ranges::find(m.rows, mode, &MeasuredMode::mode)->figures["ghosting"] = ghosting;
  };
  // the paper's own but for one pair
  set("rgb", .0520), set("ycocg", .0319), set("dop32", .0321), set("dop16-opt", .0300), set("rgb-var", .0439);
  set("ycocg-var", .0286), set("dop32-var", .0289);
  const std::string page = page_of(sample.results, {{"Because it is so."}});
  const std::string verdict = between(page, "<strong>ghosting</strong>: ", "</li>");
  EXPECT_EQ(verdict, "20 of 21 pairs are in the same order; not: <span class=\"pair\">dop32-var &lt; "
                     "ycocg-var</span> (as the "
                     "paper has them).");
  EXPECT_NE(page.find("<p>Because it is so.</p>"), std::string::npos);
}

TEST(ReportPage, WhatATimeIsNotIsSaidFirst) {
  ReportSample sample({"pass"});
  EXPECT_EQ(page_of(sample.results).find("class=\"warning\""), std::string::npos);
  sample.results.scenes.front().software = true;
  EXPECT_NE(page_of(sample.results).find("its times are not those of a GPU"), std::string::npos);
}

TEST(ReportPage, IsTheSameBytesForTheSameData) {
  const Results results = ReportSample().results;
  EXPECT_EQ(page_of(results), page_of(results));
  EXPECT_EQ(page_of(results), page_of(ReportSample().results));
}

} // namespace
} // namespace unghost
