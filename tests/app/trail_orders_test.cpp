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

TEST(TrailOrders, FromBlendToClampToTagsOnEveryRig) {
  for (const char* rig : {"drive", "rotate", "pass"}) {
    SCOPED_TRACE(rig);
    std::map<std::string, double> trail = trails(rig);
    EXPECT_GT(trail["blend"], trail["gdk-clamp"]);
    EXPECT_GT(trail["gdk-clamp"], trail["grand-tour"]);
    if (std::string(rig) == "rotate") {
      EXPECT_LE(trail["uncharted"], 0.5 * trail["gdk-clamp"]) << "tags are what disocclusion needs";
    }
    if (std::string(rig) == "drive") {
      EXPECT_LT(trail["grand-tour"], trail["uncharted"]) << "near and moving: the road";
    }
  }
}

} // namespace
} // namespace unghost
