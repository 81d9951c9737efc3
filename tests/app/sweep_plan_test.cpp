#include "app/sweep_plan.h"

#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/failure.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using nlohmann::json;

std::vector<std::string> lines_of(const json& plan) {
  std::vector<std::string> lines;
  for (const Job& job : jobs_of_plan(plan, "plan.json")) lines.push_back(line_of(job));
  return lines;
}

std::string before_output(const std::string& line) { return line.substr(0, line.find(" -o ")); }

TEST(SweepPlan, NothingSaidIsTheCommandsDefault) {
  const std::vector<std::string> lines = lines_of(json::object());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(before_output(lines[0]), "unghost measure asphalt --rig pass --size 1280x720 --seed 1");
}

TEST(SweepPlan, EveryCombinationTheLastListFirst) {
  const json plan = {{"rigs", {"drive", "pass"}},
                     {"sizes", {"64x36", "32x32"}},
                     {"seeds", {1, 18446744073709551615u}},
                     {"modes", {"gdk-clamp", "grand-tour"}},
                     {"settings", {json::object(), {{"alpha", 0.05}, {"dilation", "centre"}}}},
                     {"what", {"ghosting", "error,flicker"}},
                     {"frames", 20},
                     {"protocol", "quick"}};
  const std::vector<std::string> lines = lines_of(plan);
  ASSERT_EQ(lines.size(), 32u);
  const std::string first = "unghost measure asphalt --rig drive --size 64x36 --seed 1 "
                            "--modes gdk-clamp,grand-tour --what ";
  EXPECT_EQ(before_output(lines[0]), first + "ghosting --frames 20 --protocol quick");
  EXPECT_EQ(before_output(lines[1]), first + "error,flicker --frames 20 --protocol quick");
  EXPECT_EQ(before_output(lines[2]),
            first + "ghosting --frames 20 --protocol quick --set alpha=0.05 --set dilation=centre");
  EXPECT_NE(lines[4].find("--seed 18446744073709551615"), std::string::npos) << lines[4];
  EXPECT_NE(lines[8].find("--size 32x32 --seed 1 "), std::string::npos) << lines[8];
  EXPECT_NE(lines[16].find("--rig pass --size 64x36"), std::string::npos) << lines[16];
  const std::set<std::string> shards = [&] {
    std::set<std::string> names;
    for (const std::string& line : lines) names.insert(line.substr(line.find(" -o ")));
    return names;
  }();
  EXPECT_EQ(shards.size(), lines.size());
}

TEST(SweepPlan, ShardsAreNamedForWhatTheyHold) {
  const Job job = jobs_of_plan({{"rigs", {"drive"}}, {"sizes", {"640x360"}}}, "plan.json").front();
  const std::string& name = job.shard;
  EXPECT_EQ(name.substr(0, 24), "asphalt-drive-640x360-1-") << name;
  EXPECT_EQ(name.find_first_not_of("0123456789abcdef", 24), 40u) << name;
  EXPECT_EQ(name.substr(40), ".json") << name;
  const Job other =
      jobs_of_plan({{"rigs", {"drive"}}, {"sizes", {"640x360"}}, {"what", {"error"}}}, "").front();
  EXPECT_NE(other.shard, name);
}

TEST(SweepPlan, AFileOfAnyNameIsAScene) {
  const ScratchFolder folder;
  const std::string scene = folder.file("it's a $car; really.glb", "").string();
  const Job job = jobs_of_plan({{"scenes", {scene}}}, "plan.json").front();
  EXPECT_EQ(job.words[1], scene);
  EXPECT_TRUE(job.shard.starts_with("it-s-a--car--really-pass-")) << job.shard;
  EXPECT_EQ(job_of_line(line_of(job)), job);
}

TEST(SweepPlan, ALineIsTheJobAgain) {
  for (const Job& job : jobs_of_plan({{"rigs", {"still", "rotate"}}, {"seeds", {1, 2}}}, "plan.json"))
    EXPECT_EQ(job_of_line(line_of(job)), job) << line_of(job);
  const Job elsewhere = job_of_line("/opt/bin/unghost measure --output=out/a.json x.glb --seed 3");
  EXPECT_EQ(elsewhere.words, (Words{"measure", "x.glb", "--seed", "3"}));
  EXPECT_EQ(elsewhere.shard, "a.json");
}

TEST(SweepPlan, ALineThatIsNoJobIsRefused) {
  for (const char* line : {"", "unghost", "unghost capture -o a.json", "rm -o a.json", "unghost measure",
                           "unghost measure -o", "unghost measure -o a.png", "unghost measure -o -",
                           "unghost measure -o a.json; id", "unghost measure > a.json"})
    EXPECT_THROW(job_of_line(line), std::invalid_argument) << line;
}

TEST(SweepPlan, WhatTheCommandWouldRefuseIsRefusedInASentence) {
  const std::vector<std::pair<json, const char*>> cases = {
      {json::array(), "no JSON object"},
      {{{"scene", {"asphalt"}}}, "no member 'scene'; did you mean 'scenes'?"},
      {{{"scenes", {"asphlt"}}}, "no scene 'asphlt'; did you mean 'asphalt'?"},
      {{{"scenes", {"--json"}}}, "no scene '--json'"},
      {{{"scenes", {""}}}, "scenes has an empty word"},
      {{{"scenes", "asphalt"}}, "scenes is no list"},
      {{{"scenes", json::array()}}, "scenes is empty"},
      {{{"scenes", {json::object()}}}, "neither a word nor a number"},
      {{{"rigs", {"drive", "rotat"}}}, "no rig 'rotat'; did you mean 'rotate'?"},
      {{{"rigs", {"--json"}}}, "no rig '--json'"},
      {{{"sizes", {"64x36", "64"}}}, "WIDTHxHEIGHT"},
      {{{"sizes", {64}}}, "WIDTHxHEIGHT"},
      {{{"seeds", {-1}}}, "a seed is"},
      {{{"seeds", {1.5}}}, "a seed is"},
      {{{"modes", {"blnd"}}}, "'blend'"},
      {{{"modes", {"blend", "blend"}}}, "blend more than once"},
      {{{"settings", {{{"alfa", 0.1}}}}}, "'alpha'"},
      {{{"settings", {{{"alpha", 2}}}}}, "from 0 to 1"},
      {{{"settings", {{{"alpha", true}}}}}, "neither a word nor a number"},
      {{{"settings", {"alpha=0.1"}}}, "list of objects"},
      {{{"settings", {{{"gamma", 2}}}}, {"modes", {"blend"}}}, "has no effect"},
      {{{"what", {"ghosting", "shimer"}}}, "no 'shimer'; did you mean 'shimmer'?"},
      {{{"protocol", "quik"}}, "quik not in {quick,full}"},
      {{{"frames", 0}}, "--frames"},
      {{{"frames", "20"}}, "frames has \"20\", which is no whole number"},
      {{{"frames", {20}}}, "which is no whole number"},
      {{{"rigs", {"drive", "drive"}}}, "it has twice: measure asphalt --rig drive"},
  };
  for (const auto& [plan, expected] : cases) {
    try {
      jobs_of_plan(plan, "plan.json");
      ADD_FAILURE() << plan.dump() << " was taken";
    } catch (const Failure& failure) {
      const std::string sentence = failure.what();
      EXPECT_EQ(failure.exit, Exit::input_refused) << sentence;
      EXPECT_TRUE(sentence.starts_with("plan.json: ")) << sentence;
      EXPECT_NE(sentence.find(expected), std::string::npos) << sentence;
    }
  }
}

TEST(SweepPlan, MoreJobsThanAnybodyWantsAreRefused) {
  json seeds = json::array();
  for (size_t i = 0; i < 400; ++i) seeds.push_back(i);
  json sizes = json::array();
  for (size_t i = 0; i < 300; ++i) sizes.push_back("64x" + std::to_string(i + 1));
  EXPECT_THROW(jobs_of_plan({{"seeds", seeds}, {"sizes", sizes}}, "plan.json"), Failure);
}

} // namespace
} // namespace unghost
