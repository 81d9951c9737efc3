// Rows with settings of their own stand beside the row that they change, and nowhere else.
#include "app/measure/report/variants.h"

#include <gtest/gtest.h>

#include "app/measure/report/report_page.h"
#include "tests/app/report_sample.h"

namespace unghost {
namespace {

/// Of `base`, each figure `times` as large, in every scene, and each round.
void add_variant(Results& results, const std::string& base, const std::string& name, double times) {
  for (Measured& m : results.scenes) {
    MeasuredMode row = *std::ranges::find(m.rows, base, &MeasuredMode::mode);
    row.mode = name;
    for (auto& [figure, value] : row.figures) value *= times;
    for (auto& [figure, samples] : row.samples)
      for (double& sample : samples) sample *= times;
    m.rows.push_back(row);
    m.modes.emplace_back(name, nlohmann::json::object());
  }
}

MeasuredMode& row_of(Measured& m, const std::string& mode) {
  return *std::ranges::find(m.rows, mode, &MeasuredMode::mode);
}

void keep_rows_of(Results& results, const std::string& base) {
  for (Measured& m : results.scenes) {
    std::erase_if(m.rows, [&](const MeasuredMode& row) { return !row.mode.starts_with(base); });
    std::erase_if(m.modes, [&](const auto& mode) { return !mode.first.starts_with(base); });
  }
}

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Of the first table: the cell of the row with this text in its head, below the column of this label.
std::string cell_of(const std::string& html, const std::string& row, const std::string& label) {
  const size_t line = html.find(row, html.find("<tbody>")), column = html.find("\">" + label);
  EXPECT_NE(line, std::string::npos) << row;
  EXPECT_NE(column, std::string::npos) << label;
  size_t at = html.find("</th>", line);
  const size_t before = count(html.substr(html.find("<thead>"), column - html.find("<thead>")), "</th>");
  for (size_t cell = 0; cell < before; ++cell) at = html.find("<td", at + 1);
  return html.substr(at, html.find("</td>", at) - at);
}

class Variants : public testing::Test {
protected:
  Results results = ReportSample({"pass", "drive"}).results;
  const std::string plain = report_page(results, ReportSample::picture, {});
};

TEST_F(Variants, SayHowMuchMoreOrLessThereIs) {
  add_variant(results, "rgb", "rgb:alpha=0.05:reject=off-screen+tag", 1.5);
  add_variant(results, "rgb", "rgb:where=unknown", 0.75);
  const std::string html = variants_section(results);
  EXPECT_EQ(cell_of(html, "<code>alpha=0.05:reject=off-screen+tag</code>", "error"),
            "<td><strong>+50%</strong>")
      << "as --modes takes it";
  EXPECT_EQ(cell_of(html, "where=unknown", "error"), "<td>−25%");
  EXPECT_EQ(cell_of(html, "where=unknown", "adds"), "<td>−25%");
  EXPECT_EQ(html.find("<strong>−"), std::string::npos) << "less is better";
}

TEST_F(Variants, HaveATableACaseAndAColumnAFigure) {
  add_variant(results, "unghost", "unghost:ringing=kept", 2);
  add_variant(results, "unghost", "unghost:alpha=0.2", 3);
  for (MeasuredMode& row : results.scenes[1].rows) row.figures.erase("trail_shadow");
  const std::string html = variants_section(results);
  EXPECT_EQ(count(html, "<table"), 2u);
  for (const char* caption : {"asphalt, pass, 640x360", "asphalt, drive, 640x360"})
    EXPECT_EQ(count(html, std::string("<caption>") + caption), 1u) << caption;
  EXPECT_EQ(count(html, "<small>with the times of"), 0u);
  EXPECT_EQ(count(html, ">error <small>"), 2u);
  EXPECT_EQ(count(html, ">trail, shadows <small>"), 1u) << "only where it was measured";
  EXPECT_EQ(count(html, ">adds, 5th percentile"), 0u);
  const double error = row_of(results.scenes[0], "unghost").figures.at("error");
  EXPECT_NE(cell_of(html, "as it is", "error").find(std::to_string(error).substr(0, 5)), std::string::npos);
  EXPECT_EQ(count(html, "<th scope=\"row\">with ringing<small><code>ringing=kept</code></small></th>"), 2u);
  EXPECT_EQ(count(html, "<th scope=\"row\"><code>alpha=0.2</code></th>"), 2u);
  results.scenes[1].timing->rig = "pass";
  EXPECT_EQ(count(variants_section(results), "<small>with the times of pass</small>"), 1u);
}

TEST_F(Variants, AreToldAsTheyAreWhereNextToNothingWas) {
  add_variant(results, "rgb", "rgb:where=unknown", 9);
  add_variant(results, "rgb", "rgb:alpha=0.05", 11);
  for (Measured& m : results.scenes) {
    row_of(m, "rgb").figures["ghosting"] = 0.00001; // reads as 0
    row_of(m, "rgb:alpha=0.05").figures["ghosting"] = 0.0123;
    row_of(m, "rgb:where=unknown").figures["ghosting"] = 0.00004;
    row_of(m, "rgb").figures["trail"] = 0.009, row_of(m, "rgb:alpha=0.05").figures["trail"] = 0.423;
  }
  const std::string html = variants_section(results);
  EXPECT_EQ(cell_of(html, "where=unknown", "error"), "<td><strong>+800%</strong>");
  EXPECT_EQ(cell_of(html, "alpha=0.05", "error").substr(0, 14), "<td><strong>to");
  EXPECT_EQ(cell_of(html, "alpha=0.05", "trail"), "<td><strong>to 0.423</strong>");
  EXPECT_EQ(cell_of(html, "alpha=0.05", "ghosting"), "<td><strong>to 0.0123</strong>");
  EXPECT_EQ(cell_of(html, "where=unknown", "ghosting"), "<td class=\"none\">≈");
}

TEST_F(Variants, CostTheSameWhereTheRoundsDoNotTellThemApart) {
  add_variant(results, "rgb", "rgb:where=unknown", 1.3);
  for (Measured& m : results.scenes) { // the same rounds, and medians that differ by chance
    row_of(m, "rgb:where=unknown").samples = row_of(m, "rgb").samples;
    row_of(m, "rgb:where=unknown").samples["added_ms"].back() *= 1.1;
  }
  add_variant(results, "rgb", "rgb:alpha=0.05", 1.3);
  for (Measured& m : results.scenes) row_of(m, "rgb:alpha=0.05").samples.erase("added_over_copy");
  const std::string html = variants_section(results);
  EXPECT_TRUE(cell_of(html, "where=unknown", "adds").ends_with("≈"));
  EXPECT_EQ(cell_of(html, "where=unknown", "error"), "<td><strong>+30%</strong>");
  EXPECT_EQ(cell_of(html, "alpha=0.05", "adds"), "<td><strong>+30%</strong>");
  EXPECT_EQ(cell_of(html, "alpha=0.05", "resolve, over a copy"), "<td><strong>+30%</strong>")
      << "no round is known";
}

TEST_F(Variants, SayWhyTheyHaveNoFigure) {
  add_variant(results, "unghost", "unghost:jitter-moving=1", 2);
  for (Measured& m : results.scenes)
    for (const char* figure : {"added_ms", "error"})
      row_of(m, "unghost:jitter-moving=1").figures.erase(figure);
  const std::string html = variants_section(results);
  EXPECT_NE(cell_of(html, "jitter-moving", "adds").find("title=\"Times are taken without jitter"),
            std::string::npos);
  EXPECT_NE(cell_of(html, "jitter-moving", "error").find("title=\"Not measured"), std::string::npos);
}

TEST_F(Variants, ComeFirstWhereNothingElseWasAskedFor) {
  add_variant(results, "unghost", "unghost:ringing=kept", 2);
  const auto comes_first = [&] {
    const std::string page = report_page(results, ReportSample::picture, {});
    EXPECT_NE(page.find("id=\"variants\""), std::string::npos);
    return page.find("id=\"variants\"") < page.find("class=\"case\"");
  };
  EXPECT_FALSE(comes_first());
  keep_rows_of(results, "unghost"); // -safe and -lite are there
  EXPECT_FALSE(comes_first());
  for (const char* other : {"unghost-safe", "unghost-lite"})
    for (Measured& m : results.scenes) {
      std::erase_if(m.rows, [&](const MeasuredMode& row) { return row.mode == other; });
      std::erase_if(m.modes, [&](const auto& mode) { return mode.first == other; });
    }
  EXPECT_TRUE(comes_first());
}

TEST_F(Variants, ChangeNothingElseOfThePage) {
  add_variant(results, "rgb", "rgb:alpha=0.05", 0.01); // it would win everything
  std::string page = report_page(results, ReportSample::picture, {});
  const std::string section = variants_section(results);
  ASSERT_NE(page.find(section), std::string::npos);
  EXPECT_EQ(page.erase(page.find(section), section.size()), plain);
}

TEST_F(Variants, OfARowThatIsNotThereAreRowsOfTheirOwn) {
  add_variant(results, "rgb", "ycocg-var:alpha=0.05", 2);
  for (Measured& m : results.scenes)
    std::erase_if(m.rows, [](const MeasuredMode& row) { return row.mode == "ycocg-var"; });
  EXPECT_EQ(variants_section(results), "");
  EXPECT_EQ(without_variants(results).scenes[0].rows.size(), results.scenes[0].rows.size());
}

} // namespace
} // namespace unghost
