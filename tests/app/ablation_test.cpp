// `report --ablation`: every part is one that the row has, is measured, and is explained.
#include "app/measure/report/ablation.h"

#include <set>

#include <gtest/gtest.h>

#include "app/command_line.h"
#include "app/report_plan.h"
#include "renderer/settings.h"
#include "tests/app/report_sample.h"

namespace unghost {
namespace {

std::vector<Job> jobs_of(std::vector<const char*> words) {
  return report_jobs(std::get<CommandLine>(parse_command_line(words)));
}

std::vector<std::string> modes_of(const Job& job) {
  const auto modes = std::ranges::find(job.words, "--modes");
  std::vector<std::string> names;
  if (modes == job.words.end()) return names;
  std::istringstream list(*std::next(modes));
  for (std::string name; std::getline(list, name, ',');) names.push_back(name);
  return names;
}

TEST(Ablation, TakesOutWhatTheRowHas) {
  const TaaSettings row = find_taa_mode(ablated_row)->settings;
  for (const Part& part : parts()) {
    ModeRun without;
    ASSERT_NO_THROW(without = mode_run(name_without(part))) << part.change;
    EXPECT_FALSE(without.taa == row) << part.change << ": the row does without it";
  }
}

TEST(Ablation, TakesSpeedOutByTheRowsOwnAlpha) {
  const TaaSettings row = find_taa_mode(ablated_row)->settings;
  const auto speed =
      std::ranges::find_if(parts(), [](const Part& part) { return part.change.starts_with("fast-alpha="); });
  ASSERT_NE(speed, parts().end());
  TaaSettings without = row;
  without.fast_alpha = row.alpha; // what is fast weighs as all else
  EXPECT_TRUE(mode_run(name_without(*speed)).taa == without);
}

TEST(Ablation, CallsEachPartByANameOfItsOwn) {
  std::set<std::string_view> names;
  for (const Part& part : parts()) {
    EXPECT_TRUE(part.name.starts_with("with")) << part.name;
    EXPECT_TRUE(names.insert(part.name).second) << part.name;
    EXPECT_EQ(find_part(name_without(part)), &part);
  }
  EXPECT_EQ(find_part("unghost"), nullptr);
  EXPECT_EQ(find_part("unghost-safe:ringing=kept"), nullptr);
}

TEST(Ablation, IsMeasuredOnEveryRigAndTimedWhereItCanBe) {
  size_t rigs = 0, timed = 0;
  for (const Job& job : jobs_of({"report", "--ablation", "--size", "64x36", "-o", "page"})) {
    const std::vector<std::string> modes = modes_of(job);
    const bool times = std::ranges::find(job.words, "time") != job.words.end();
    (times ? timed : rigs) += 1;
    EXPECT_EQ(modes.front(), "all");
    for (const Part& part : parts())
      EXPECT_EQ(std::ranges::count(modes, name_without(part)),
                times && part.change.starts_with("jitter") ? 0 : 1);
  }
  EXPECT_EQ(rigs, 5u);
  EXPECT_EQ(timed, 1u);
  for (const Job& job : jobs_of({"report", "-o", "page"})) EXPECT_TRUE(modes_of(job).empty());
}

TEST(Ablation, BringsItsRowAlong) {
  const std::vector<std::string> modes =
      modes_of(jobs_of({"report", "--ablation", "--modes", "rgb", "-o", "page"}).front());
  EXPECT_EQ(modes[0], "rgb");
  EXPECT_EQ(modes[1], ablated_row);
  EXPECT_EQ(modes.size(), 2 + parts().size());
}

TEST(Ablation, ExplainsThePartsThatWereMeasured) {
  const std::vector<std::string> names = {"unghost:ringing=kept", "unghost:reject=off-screen+visibility",
                                          "unghost:alpha=0.2"};
  const std::string html = parts_explained(names);
  EXPECT_NE(html.find("<code>ringing=kept</code>"), std::string::npos);
  EXPECT_NE(html.find("<code>reject=off-screen+visibility</code>"), std::string::npos);
  EXPECT_NE(html.find("without moved objects"), std::string::npos);
  EXPECT_EQ(html.find("zoom-weight"), std::string::npos);
  EXPECT_EQ(parts_explained(std::vector<std::string>{"unghost:alpha=0.2"}), "");
}

} // namespace
} // namespace unghost
