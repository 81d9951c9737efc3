#include "app/measure/baseline.h"

#include <random>

#include <gtest/gtest.h>

#include "app/baseline_table.h"

namespace unghost {
namespace {

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / double(values.size());
}

std::vector<double> wandering(unsigned seed, size_t count, double scale = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.05, 0.005);
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) values.push_back(scale * normal(random));
  return values;
}

/// One mode, `uncharted`, with one figure that is the mean of its samples.
Measured measured(const std::string& figure, std::vector<double> samples) {
  Measured m{.device = "llvmpipe", .driver = "Mesa 1", .scene = "asphalt", .rig = "drive"};
  m.width = 64, m.height = 36;
  m.settings = {{"speed", 1}};
  m.modes = {{"uncharted", {{"alpha", 0.1}}}};
  MeasuredMode row{.mode = "uncharted", .figures = {{figure, mean(samples)}}, .samples = {}};
  row.samples[figure] = std::move(samples);
  m.rows = {row};
  return m;
}

Measured timed(std::vector<double> over_copy, const std::string& host = "here") {
  Measured m = measured("added_over_copy", std::move(over_copy));
  m.timing = {.host = host, .rig = "drive", .rounds = 31, .copy_ms = 1, .motion_ms = 2};
  return m;
}

BaselineComparison compared(const Measured& before, const Measured& now, double allowed = 0.05) {
  return compared_with({.protocol = "quick", .scenes = {before}}, {.protocol = "quick", .scenes = {now}},
                       allowed);
}

Change only(const BaselineComparison& comparison) {
  EXPECT_EQ(comparison.changes.size(), 1u);
  EXPECT_TRUE(comparison.missing.empty()) << comparison.missing.front();
  return comparison.changes.empty() ? Change{} : comparison.changes.front();
}

std::vector<double> times(const std::vector<double>& values, double by) {
  std::vector<double> scaled = values;
  for (double& value : scaled) value *= by;
  return scaled;
}

TEST(Baseline, WhatHasNotChangedIsTheSame) {
  const Measured m = measured("ghosting", wandering(1, 100));
  const Change change = only(compared(m, m));
  EXPECT_EQ(change.verdict, Verdict::same);
  EXPECT_FALSE(change.regression);
  EXPECT_EQ(change.change, 0);
  EXPECT_EQ(change.before, change.after);
  EXPECT_EQ(only(compared(timed({1, 2, 3}), timed({1, 2, 3}))).verdict, Verdict::same);
}

TEST(Baseline, AKnownShiftIsFound) {
  const std::vector<double> before = wandering(1, 100);
  for (const double shift : {-0.2, -0.01, 0.01, 0.2}) {
    const Change change =
        only(compared(measured("flicker", before), measured("flicker", times(before, 1 + shift))));
    EXPECT_EQ(change.verdict, shift > 0 ? Verdict::worse : Verdict::better) << shift;
    EXPECT_NEAR(change.change, shift, 1e-9);
    EXPECT_EQ(change.figure, "flicker");
    EXPECT_EQ(change.mode, "uncharted");
    EXPECT_EQ(change.width, 64u);
  }
}

TEST(Baseline, AShiftWithinTheNoiseIsNoise) {
  int noise = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Change change = only(compared(measured("shimmer", wandering(seed, 100)),
                                        measured("shimmer", wandering(seed + 1000, 100)), 0));
    noise += change.verdict == Verdict::noise;
    EXPECT_TRUE(change.verdict != Verdict::noise || !change.regression);
  }
  EXPECT_GE(noise, 34);
}

TEST(Baseline, ARegressionIsWorseByMoreThanIsAllowed) {
  const std::vector<double> before = wandering(1, 100);
  const auto regression = [&](double shift, double allowed) {
    return only(compared(measured("ghosting", before), measured("ghosting", times(before, 1 + shift)),
                         allowed))
        .regression;
  };
  EXPECT_FALSE(regression(0.04, 0.05));
  EXPECT_TRUE(regression(0.06, 0.05));
  EXPECT_TRUE(regression(0.001, 0));
  EXPECT_FALSE(regression(-0.2, 0.05));
  const Measured noisy = measured("ghosting", {0.01, 0.09, 0.05, 0.02, 0.08, 0.03, 0.07, 0.04});
  const Measured other = measured("ghosting", {0.09, 0.04, 0.09, 0.09, 0.01, 0.09, 0.02, 0.06});
  const Change change = only(compared(noisy, other));
  EXPECT_GT(change.change, 0.2);
  EXPECT_FALSE(change.regression);
}

TEST(Baseline, TrailIsAShareOfSums) {
  Measured before = measured("trail", {0.1}), now = before;
  before.rows[0].samples = {{"trail_remaining", wandering(3, 40)}, {"trail_all", wandering(4, 40, 10)}};
  now.rows[0].samples = before.rows[0].samples;
  for (double& value : now.rows[0].samples["trail_remaining"]) value *= 1.5;
  const Change change = only(compared(before, now));
  EXPECT_NEAR(change.before, 0.1, 0.01);
  EXPECT_NEAR(change.change, 0.5, 1e-9);
  EXPECT_TRUE(change.regression);
}

TEST(Baseline, AFigureOfNothingChangesByWhatCanBeRead) {
  const auto flat = [](double value) { return measured("ghosting", std::vector<double>(20, value)); };
  EXPECT_NEAR(only(compared(flat(0), flat(0.00004))).change, 0.04, 1e-12);
  EXPECT_FALSE(only(compared(flat(0), flat(0.00004))).regression);
  EXPECT_TRUE(only(compared(flat(0), flat(0.0002))).regression);
  EXPECT_NEAR(only(compared(flat(0.0002), flat(0))).change, -0.2, 1e-12);
}

TEST(Baseline, AnotherNumberOfFramesIsNotPaired) {
  const std::vector<double> few = wandering(1, 50), many = wandering(1, 100);
  const Change change = only(compared(measured("ghosting", many), measured("ghosting", times(few, 1.002))));
  EXPECT_EQ(change.verdict, Verdict::noise);
  EXPECT_EQ(only(compared(measured("ghosting", many), measured("ghosting", times(few, 1.5)))).verdict,
            Verdict::worse);
}

// Supersampled in pairs of neighbours: two pairs tell as much as two frames.
TEST(Baseline, NeighboursAmongSupersampledFramesCountOnce) {
  Measured before = measured("error", {0.1, 0.1, 0.1, 0.1}),
           now = measured("error", {0.11, 0.11, 0.13, 0.13});
  before.error_frames = now.error_frames = {20, 21, 30, 31};
  const Change change = only(compared(before, now));
  EXPECT_NEAR(change.change, 0.2, 1e-9);
  EXPECT_NEAR(change.high, 0.2 + 0.9168, 1e-3); // as two frames by hand in bootstrap_test.cpp
  EXPECT_EQ(change.verdict, Verdict::noise);
  before.error_frames = now.error_frames = {20, 21, 22, 23};
  EXPECT_EQ(only(compared(before, now)).verdict, Verdict::worse);
}

TEST(Baseline, TimesAreRatiosOnOneMachine) {
  const std::vector<double> before = wandering(5, 31, 40);
  const Change change = only(compared(timed(before), timed(times(before, 1.3))));
  EXPECT_EQ(change.verdict, Verdict::worse);
  EXPECT_NEAR(change.change, 0.3, 1e-9);
  Measured ms = timed(before), slower = ms;
  ms.rows[0].figures["added_ms"] = 1, slower.rows[0].figures["added_ms"] = 5;
  EXPECT_EQ(only(compared(ms, slower)).verdict, Verdict::same); // only the ratio is compared
  const BaselineComparison elsewhere = compared(timed(before), timed(times(before, 1.3), "there"));
  EXPECT_TRUE(elsewhere.changes.empty());
  ASSERT_EQ(elsewhere.missing.size(), 1u);
  EXPECT_NE(elsewhere.missing[0].find("one host"), std::string::npos) << elsewhere.missing[0];
  Measured validated = timed(before);
  validated.validation = true;
  EXPECT_TRUE(compared(timed(before), validated).changes.empty());
}

TEST(Baseline, EntriesOfAMachineFindOneAnother) {
  const std::vector<double> here = wandering(5, 31, 40), there = wandering(6, 31, 400);
  const Results before{.protocol = "quick", .scenes = {timed(here, "here"), timed(there, "there")}};
  const Results now{.protocol = "quick", .scenes = {timed(there, "there"), timed(here, "here")}};
  const BaselineComparison comparison = compared_with(before, now, 0.05);
  ASSERT_EQ(comparison.changes.size(), 2u);
  for (const Change& change : comparison.changes) EXPECT_EQ(change.verdict, Verdict::same);
  const BaselineComparison more =
      compared_with({.protocol = "quick", .scenes = {timed(here, "here")}}, now, 0);
  ASSERT_EQ(more.changes.size(), 1u);
  EXPECT_EQ(more.changes[0].verdict, Verdict::same);
  EXPECT_EQ(more.missing.size(), 1u);
}

TEST(Baseline, WhatIsInOneOnlyIsSaid) {
  const Measured ghosting = measured("ghosting", wandering(1, 20));
  const auto expect_said = [](const BaselineComparison& comparison, const std::string& said) {
    ASSERT_EQ(comparison.missing.size(), 1u) << said;
    EXPECT_EQ(comparison.missing[0], said);
  };
  Measured other_seed = ghosting;
  other_seed.seed = 2, other_seed.set = {"alpha=0.05"};
  const BaselineComparison apart = compared(ghosting, other_seed);
  EXPECT_TRUE(apart.changes.empty());
  EXPECT_EQ(apart.missing,
            (std::vector<std::string>{"asphalt, drive, 64x36, seed 2, alpha=0.05: is not in the baseline",
                                      "asphalt, drive, 64x36, seed 1: is in the baseline and not here"}));

  Measured two_modes = ghosting;
  two_modes.modes.push_back({"blend", {}}),
      two_modes.rows.push_back({.mode = "blend", .figures = {}, .samples = {}});
  expect_said(compared(ghosting, two_modes), "asphalt, drive, 64x36, seed 1: blend is not in the baseline");
  expect_said(compared(two_modes, ghosting),
              "asphalt, drive, 64x36, seed 1: blend is in the baseline and not here");

  Measured more = ghosting;
  more.rows[0].figures["error"] = 0.1;
  expect_said(compared(ghosting, more), "asphalt, drive, 64x36, seed 1: uncharted has error only here");
  expect_said(compared(more, ghosting),
              "asphalt, drive, 64x36, seed 1: uncharted has error only in the baseline");
  expect_said(compared(more, more),
              "asphalt, drive, 64x36, seed 1: uncharted: error has too few samples to be compared");
}

TEST(Baseline, SettingsThatDifferAreSaidAndFiguresCompared) {
  const Measured before = measured("ghosting", wandering(1, 20));
  Measured now = before;
  now.settings["speed"] = 2, now.modes[0].second["alpha"] = 0.05, now.driver = "Mesa 2";
  const BaselineComparison comparison = compared(before, now);
  EXPECT_EQ(comparison.changes.size(), 1u);
  const std::string where = "asphalt, drive, 64x36, seed 1: ";
  EXPECT_EQ(comparison.missing,
            (std::vector<std::string>{where + "was measured on llvmpipe, Mesa 1 and now on llvmpipe, Mesa 2",
                                      where + "speed was 1 and is 2",
                                      where + "uncharted: alpha was 0.1 and is 0.05"}));
}

TEST(Baseline, TextBeginsWithRegressionsAndCountsWhatIsTheSame) {
  const std::vector<double> samples = wandering(1, 100);
  Measured before = measured("ghosting", samples), now = measured("ghosting", times(samples, 1.02));
  for (const char* figure : {"shimmer", "flicker"})
    for (Measured* m : {&before, &now})
      m->rows[0].figures[figure] = 0.05, m->rows[0].samples[figure] = samples;
  now.rows[0].samples["flicker"] = times(samples, 1.1);
  const std::string text = comparison_text(compared(before, now));
  EXPECT_LT(text.find("REGRESSION"), text.find("ghosting")) << text;
  EXPECT_NE(text.find("+10.0%"), std::string::npos) << text;
  EXPECT_EQ(text.find("shimmer"), std::string::npos) << text;
  EXPECT_NE(text.find("1 of 3 figures are the same in every sample; 1 are worse by more than 5.0%"),
            std::string::npos)
      << text;
  const auto object = comparison_json(compared(before, now));
  EXPECT_EQ(object.at("regressions"), 1);
  EXPECT_EQ(object.at("changes").size(), 3u);
  EXPECT_EQ(object.at("changes")[0].at("verdict"), "worse");
  EXPECT_EQ(object.at("changes")[0].at("size"), "64x36");
}

} // namespace
} // namespace unghost
