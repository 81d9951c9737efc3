// Rows with settings of their own stand beside the row that they change, and nowhere else.
#include "app/measure/report/variants.h"

#include <gtest/gtest.h>

#include "app/measure/report/report_page.h"
#include "tests/app/report_sample.h"

namespace unghost {
namespace {

/// Of `base`, each figure `times` as large, in every scene.
void add_variant(Results& results, const std::string& base, const std::string& name, double times) {
  for (Measured& m : results.scenes) {
    MeasuredMode row = *std::ranges::find(m.rows, base, &MeasuredMode::mode);
    row.mode = name;
    for (auto& [figure, value] : row.figures) value *= times;
    m.rows.push_back(row);
    m.modes.emplace_back(name, nlohmann::json::object());
  }
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
  EXPECT_NE(html.find("alpha=0.05, reject=off-screen,tag"), std::string::npos);
  EXPECT_NE(html.find("<strong>+50%</strong>"), std::string::npos);
  EXPECT_NE(html.find("<td>−25%</td>"), std::string::npos);
  EXPECT_EQ(html.find("<strong>−"), std::string::npos) << "less is better";
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
