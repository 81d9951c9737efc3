#include "app/measure/results.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "app/failure.h"

namespace unghost {
namespace {

Measured part(const std::string& rig, const std::map<std::string, double>& figures) {
  Measured m;
  m.version = "1", m.build = "b", m.device = "d", m.driver = "v", m.scene = "asphalt", m.rig = rig;
  m.width = 64, m.height = 36, m.frames = 32, m.fill = 16, m.protocol = "quick";
  m.settings = nlohmann::json::object();
  m.modes = {{"blend", nlohmann::json::object()}};
  m.rows = {{.mode = "blend", .figures = figures, .samples = {}}};
  return m;
}

Measured timed(const std::string& rig, const std::string& host, double ms) {
  Measured m = part(rig, {{"added_ms", ms}});
  m.timing = Timing{.host = host, .rig = rig, .rounds = 31, .copy_ms = 1, .motion_ms = 2, .geometry_ms = 3};
  return m;
}

double figure(const Measured& m, const std::string& name) { return m.rows.at(0).figures.at(name); }

TEST(Results, ComeBackFromJsonAsTheyWere) {
  Measured m = timed("drive", "here", 4.25);
  m.rows[0].samples["added_ms"] = {4, 4.5};
  m.supersampled = {{.samples = 2, .figures = {{"error", 0.1}}}};
  m.convergence =
      Convergence{.frames = {1, 2}, .curves = {{.kind = "mode", .name = "blend", .error = {0.2, 0.1}}}};
  m.kept = {
      {.kind = "error", .mode = "blend", .frame = 3, .flip = 0.5, .picture = "a.png", .reference = "b.png"}};
  m.error_frames = {2, 3}, m.samples = 64, m.set = {"alpha=0.05"}, m.words = {"measure"}, m.inputs = "0";
  const nlohmann::json written = results_json({.protocol = "quick", .scenes = {m}});
  const Results read = results_from_json(nlohmann::json::parse(written.dump()), "r.json");
  EXPECT_EQ(results_json(read), written);
}

TEST(Results, AMissingMemberIsASentence) {
  const nlohmann::json whole = measured_json(timed("drive", "here", 1));
  for (const auto& [member, value] : whole.items()) {
    nlohmann::json without = whole;
    without.erase(member);
    EXPECT_THROW(measured_from_json(without, "a.json"), Failure) << member;
    without[member] = nlohmann::json::array({nlohmann::json::array({true})});
    EXPECT_THROW(measured_from_json(without, "a.json"), Failure) << member;
  }
  nlohmann::json results = results_json({.protocol = "quick", .scenes = {}});
  results["protocol"] = 5;
  EXPECT_THROW(results_from_json(results, "r.json"), Failure);
}

TEST(Results, TimesOfOneRigServeTheOthersOfItsScene) {
  const std::vector<Measured> entries =
      merged({part("pass", {{"error", 0.1}}), part("drive", {{"error", 0.2}}), timed("drive", "here", 7)});
  ASSERT_EQ(entries.size(), 2u);
  for (const Measured& m : entries) {
    EXPECT_EQ(figure(m, "added_ms"), 7) << m.rig;
    EXPECT_EQ(m.timing->rig, "drive") << m.rig;
  }
}

TEST(Results, AnOwnTimeIsNotReplacedByALentOne) {
  const auto once = merged({part("pass", {{"error", 0.1}}), timed("drive", "here", 7)});
  std::vector<Measured> parts = once; // merged before, with lent times
  parts.push_back(timed("pass", "here", 9));
  for (int turn = 0; turn < 2; ++turn, std::ranges::reverse(parts))
    for (const Measured& m : merged(parts))
      EXPECT_EQ(figure(m, "added_ms"), m.rig == "pass" ? 9 : 7) << m.rig;
}

TEST(Results, TimesOfTwoHostsStayApartAndShareTheErrors) {
  const auto entries =
      merged({timed("drive", "b", 2), part("drive", {{"error", 0.2}}), timed("drive", "a", 1)});
  ASSERT_EQ(entries.size(), 2u);
  for (const Measured& m : entries) {
    EXPECT_EQ(figure(m, "error"), 0.2);
    EXPECT_EQ(figure(m, "added_ms"), m.timing->host == "a" ? 1 : 2);
  }
}

TEST(Results, WhatWasMadeFromOtherFilesDoesNotMeet) {
  Measured other = part("drive", {{"error", 0.1}});
  other.inputs = "another scene";
  EXPECT_EQ(merged({part("drive", {{"ghosting", 0.2}}), other}).size(), 2u);
}

TEST(Results, CsvHasALineAModeAndNoFormulas) {
  Measured m = timed("drive", "", 7);
  m.scene = "=cmd()", m.device = "a \"b\", c";
  const std::string csv = results_csv({.protocol = "quick", .scenes = {m}});
  EXPECT_EQ(std::ranges::count(csv, '\n'), 2);
  EXPECT_NE(csv.find("\r\n'=cmd(),drive,64x36,1,blend,,\"a \"\"b\"\", c\",v,b,"), std::string::npos) << csv;
}

} // namespace
} // namespace unghost
