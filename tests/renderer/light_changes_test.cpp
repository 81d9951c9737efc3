// Where light may be another than in the last frame: everywhere that it is, in whatever order frames are
// drawn.
#include "renderer/light_changes.h"

#include <gtest/gtest.h>

#include "renderer/sun.h"
#include "shaders/shared/shadow.h"

namespace unghost {
namespace {

class LightChanges : public testing::Test {
protected:
  void SetUp() override {
    now.map_place = {0, 0};
    describe();
  }
  bool describe() {
    constants = {};
    constants.underside_half = underside_half;
    return describe_light_changes(constants, input, now, before);
  }
  bool everywhere() const { return (constants.light_changes & LIGHT_CHANGES_ALL) != 0; }
  bool in_map(glm::vec2 texel) const {
    const glm::vec2 at = texel / float(shadow_texels);
    return glm::all(glm::greaterThanEqual(at, constants.shadows_move_from)) &&
           glm::all(glm::lessThanEqual(at, constants.shadows_move_to));
  }

  FrameInput input;
  LightNow now;
  LastLight before;
  FrameConstants constants{};
  glm::vec2 underside_half{1, 2};
};

TEST_F(LightChanges, WhatRestsKeepsItsLight) {
  EXPECT_FALSE(describe());
  EXPECT_FALSE(everywhere());
  EXPECT_FALSE(in_map({0, 0}) || in_map({512, 512}));
}

TEST_F(LightChanges, AreWhereCastersAreAndWere) {
  now.swept_shadows = {{100, 200}, {40, 20}};
  constexpr float reach = 0.99f * SHADOW_REACH_TEXELS;
  for (int frame = 0; frame < 2; ++frame) { // whatever the frame before was
    EXPECT_TRUE(describe());
    EXPECT_FALSE(everywhere());
    EXPECT_TRUE(in_map({100, 200}) && in_map({140, 220}));
    EXPECT_TRUE(in_map(glm::vec2(100, 200) - reach) && in_map(glm::vec2(140, 220) + reach));
    EXPECT_FALSE(in_map({90, 210}) || in_map({120, 230}));
  }
  input.settings.light.sun_illuminance = 0;
  describe(); // the light itself changes
  EXPECT_FALSE(describe());
  EXPECT_FALSE(in_map({100, 200})) << "there is no shadow without a sun";
}

TEST_F(LightChanges, AreEverywhereWhereTheSunOrALampOrTheMapIsAnother) {
  input.now.towards_sun = glm::normalize(glm::dvec3(1, 1, 0));
  EXPECT_TRUE(describe() && everywhere());
  input.before.towards_sun = input.now.towards_sun;
  EXPECT_FALSE(describe());
  now.lamps_moved = true;
  EXPECT_TRUE(describe() && everywhere());
  now.lamps_moved = false;
  now.map_place = {9, 0};
  EXPECT_TRUE(describe() && everywhere());
  EXPECT_FALSE(describe());
  input.settings.light.sun_illuminance *= 2;
  EXPECT_TRUE(describe() && everywhere());
}

TEST_F(LightChanges, BelowTheVehicleAreWhereItMoves) {
  input.now.vehicle[3].x += 0.5;
  EXPECT_TRUE(describe());
  EXPECT_FALSE(everywhere());
  EXPECT_NE(constants.light_changes & LIGHT_CHANGES_UNDERSIDE, 0u);
  underside_half = {0, 0};
  EXPECT_FALSE(describe()) << "there is none";
}

TEST_F(LightChanges, AreWhereObjectsCameToOtherLight) {
  now.objects_moved = true;
  EXPECT_TRUE(describe());
  EXPECT_FALSE(everywhere());
}

} // namespace
} // namespace unghost
