// What the modes are for, as inequalities: which leaves how much of a ghost on which rig.
#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/outcome.h"

namespace unghost {
namespace {

/// Trail by mode; a validation message would have ended the run with another exit code.
std::map<std::string, double> trails(const std::string& rig, const Words& more = {}) {
  Words words{"measure", "--rig",    rig,  "--what",     "trail", "--size",
              "256x144", "--frames", "26", "--validate", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const Outcome run = outcome(words);
  EXPECT_EQ(run.exit, 0) << run.err;
  std::map<std::string, double> trail;
  const nlohmann::json object = nlohmann::json::parse(run.out);
  for (const auto& row : object.at("rows")) {
    const std::string mode = row.at("mode").get<std::string>();
    trail[mode] = row.at("trail").get<double>();
    if (!row.at("trail_shadow").is_null()) trail[mode + " shadow"] = row.at("trail_shadow").get<double>();
    std::printf("%-8s %-12s %.4f\n", rig.c_str(), mode.c_str(), trail[mode]);
  }
  return trail;
}

/// What holds on every rig.
std::map<std::string, double> ordered_trails(const char* rig) {
  const std::map<std::string, double> trail = trails(rig);
  EXPECT_GT(trail.at("blend"), trail.at("gdk-clamp"));
  EXPECT_GT(trail.at("gdk-clamp"), trail.at("grand-tour"));
  EXPECT_GT(trail.at("gdk-clamp"), trail.at("gdk-clip")) << "a clip comes nearer to the current colour";
  EXPECT_GT(trail.at("gdk-clamp"), trail.at("gdk-variance"));
  EXPECT_GT(trail.at("rgb"), trail.at("rgb-var")) << "a variance is tighter than the box it is taken in";
  EXPECT_GT(trail.at("ycocg"), trail.at("ycocg-var"));
  EXPECT_GT(trail.at("dop32"), trail.at("dop32-var"));
  EXPECT_GT(trail.at("rgb"), trail.at("dop32")) << "32 faces are tighter than 6";
  EXPECT_GT(trail.at("rgb"), trail.at("dop16-opt")) << "and so are 16 that were found for this asphalt";
  EXPECT_GT(trail.at("gdk-clamp"), trail.at("holy-trail"));
  EXPECT_GT(trail.at("gdk-clamp"), trail.at("rgb")) << "a clip from a dilated, sharp history";
  EXPECT_GT(trail.at("rgb"), trail.at("ycocg")) << "chroma varies less than RGB does on asphalt";
  EXPECT_GT(trail.at("blend"), trail.at("crytek-2x")) << "two frames hold a ghost for one";
  EXPECT_GT(trail.at("crytek-2x"), trail.at("ac4")) << "speed rejects what lengths do not";
  return trail;
}

TEST(TrailOrders, DriveNeedsMoreThanTags) {
  const std::map<std::string, double> trail = ordered_trails("drive");
  EXPECT_LT(trail.at("grand-tour"), trail.at("uncharted")) << "near and moving: the road";
  EXPECT_GT(trail.at("crytek-2x shadow"), 4 * trail.at("ac4 shadow"))
      << "the shadow moves over a road that moves alike";
}

TEST(TrailOrders, RotateNeedsTags) {
  const std::map<std::string, double> trail = ordered_trails("rotate");
  EXPECT_LE(trail.at("uncharted"), 0.5 * trail.at("gdk-clamp")) << "disocclusion beside the vehicle";
}

TEST(TrailOrders, PassLeavesTheMovingShadow) {
  const std::map<std::string, double> trail = ordered_trails("pass");
  EXPECT_DOUBLE_EQ(trail.at("grand-tour"), trail.at("uncharted"))
      << "ground that rests is never near and moving";
}

TEST(TrailOrders, OverheadNeedsThresholdsThatFollowTheVehicle) {
  const auto trail_of = [](const char* rig, const Words& more) {
    Words words{"--modes", "grand-tour"};
    words.insert(words.end(), more.begin(), more.end());
    return trails(rig, words).at("grand-tour");
  };
  const Words behind_the_car{"--set", "near=8", "--set", "far=12"}; // metres, right for the camera of `drive`
  const double found = trail_of("overhead", {});
  EXPECT_LE(found, trail_of("drive", {}));
  EXPECT_GT(trail_of("overhead", behind_the_car), found + 0.01);
}

} // namespace
} // namespace unghost
