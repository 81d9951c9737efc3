#include "app/report_notes.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/measure/report/paper_tables.h"

namespace unghost {
namespace {

/// The paper's asphalt as if we had measured it, each figure the same in all frames but for a little.
Measured as_in_the_paper() {
  const PaperTable& table = paper_tables().back();
  Measured m;
  m.scene = table.scene, m.rig = table.rig, m.width = 640, m.height = 360;
  for (const PaperRow& row : table.rows) {
    MeasuredMode& mode = m.rows.emplace_back();
    mode.mode = row.mode;
    mode.figures = {{"ghosting", row.ghosting}, {"shimmer", row.shimmer}, {"over_copy", 10 * row.ms}};
    for (const auto& [figure, value] : mode.figures)
      for (int i = 0; i < 16; ++i) mode.samples[figure].push_back(value * (1 + 0.001 * (i % 4 - 1.5)));
  }
  return m;
}

MeasuredMode& row(Measured& m, const std::string& mode) {
  return *std::ranges::find(m.rows, mode, &MeasuredMode::mode);
}

TEST(ReportNotes, WhereTheOrderIsThePapersThereIsNothingToExplain) {
  EXPECT_TRUE(report_notes({.protocol = "quick", .scenes = {as_in_the_paper()}}).paragraphs.empty());
}

TEST(ReportNotes, APairInAnotherOrderIsExplainedByWhatWasMeasured) {
  Measured m = as_in_the_paper();
  // the paper: dop16-opt .0300, ycocg-var .0289; and the other way round in its grass
  row(m, "dop16-opt").figures["ghosting"] = 0.0287;
  for (double& sample : row(m, "dop16-opt").samples["ghosting"]) sample *= 0.0287 / 0.0300;
  const auto notes = report_notes({.protocol = "quick", .scenes = {m}}).paragraphs;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("At 640x360 dop16-opt ghosts less than ycocg-var: 0.0287 and 0.0289"),
            std::string::npos)
      << notes[0];
  EXPECT_NE(notes[0].find("no chance of these frames"), std::string::npos) << notes[0];
  EXPECT_NE(notes[0].find("own grass the order is as here"), std::string::npos) << notes[0];
}

TEST(ReportNotes, EverySizeAndColumnIsExplainedOnce) {
  Measured large = as_in_the_paper(), small = as_in_the_paper();
  large.width = 1280, large.height = 720;
  for (Measured* m : {&large, &small}) row(*m, "dop16-opt").figures["ghosting"] = 0.0287;
  row(small, "rgb-var").figures["over_copy"] = 4.2; // the paper: rgb .428, rgb-var .466
  row(small, "rgb-var").samples["over_copy"] = {4.1, 4.2, 4.3};
  row(small, "rgb").samples.clear();
  const auto notes = report_notes({.protocol = "quick", .scenes = {small, large}}).paragraphs;
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_NE(notes[0].find("At 1280x720 dop16-opt ghosts less than ycocg-var"), std::string::npos) << notes[0];
  EXPECT_NE(notes[1].find("At 640x360 rgb-var takes less time than rgb: 4.20 and 4.28"), std::string::npos)
      << notes[1];
  EXPECT_EQ(notes[1].find("95%"), std::string::npos) << "of samples that are not there: " << notes[1];
}

TEST(ReportNotes, UnequalNumbersOfFramesAreNotPaired) {
  Measured m = as_in_the_paper();
  row(m, "dop16-opt").figures["ghosting"] = 0.0287;
  row(m, "dop16-opt").samples["ghosting"] = {0.0286, 0.0288};
  const auto notes = report_notes({.protocol = "quick", .scenes = {m}}).paragraphs;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].find("nan"), std::string::npos) << notes[0];
}

} // namespace
} // namespace unghost
