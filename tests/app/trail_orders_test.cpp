// What the modes are for, as inequalities: which leaves how much of a ghost on which rig.
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/outcome.h"

namespace unghost {
namespace {

/// Trail by mode; a validation message would have ended the run with another exit code.
std::map<std::string, double> trails(const std::string& rig) {
  const Outcome run = outcome({"measure", "--rig", rig, "--modes", "blend,gdk-clamp,uncharted,grand-tour",
                               "--what", "trail", "--size", "320x180", "--validate", "--json"});
  EXPECT_EQ(run.exit, 0) << run.err;
  std::map<std::string, double> trail;
  const nlohmann::json object = nlohmann::json::parse(run.out);
  for (const auto& row : object.at("rows")) {
    trail[row.at("mode").get<std::string>()] = row.at("trail").get<double>();
    std::printf("%-8s %-12s %.4f\n", rig.c_str(), row.at("mode").get<std::string>().c_str(),
                row.at("trail").get<double>());
  }
  return trail;
}

/// What holds on every rig.
std::map<std::string, double> ordered_trails(const char* rig) {
  std::map<std::string, double> trail = trails(rig);
  EXPECT_GT(trail["blend"], trail["gdk-clamp"]);
  EXPECT_GT(trail["gdk-clamp"], trail["grand-tour"]);
  return trail;
}

TEST(TrailOrders, DriveNeedsMoreThanTags) {
  std::map<std::string, double> trail = ordered_trails("drive");
  EXPECT_LT(trail["grand-tour"], trail["uncharted"]) << "near and moving: the road";
}

TEST(TrailOrders, RotateNeedsTags) {
  std::map<std::string, double> trail = ordered_trails("rotate");
  EXPECT_LE(trail["uncharted"], 0.5 * trail["gdk-clamp"]) << "disocclusion beside the vehicle";
}

TEST(TrailOrders, PassLeavesTheMovingShadow) {
  std::map<std::string, double> trail = ordered_trails("pass");
  EXPECT_DOUBLE_EQ(trail["grand-tour"], trail["uncharted"]) << "ground that rests is never near and moving";
}

} // namespace
} // namespace unghost
