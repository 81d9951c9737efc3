#include "app/stage.h"

#include <gtest/gtest.h>

#include "app/failure.h"
#include "renderer/scene/animation.h"
#include "renderer/scene/bounds.h"
#include "tests/app/scratch_folder.h"
#include "tests/app/triangle_model.h"

namespace unghost {
namespace {

using nlohmann::json;

/// A road with a car of our own on it.
json road() {
  json file = model({2, 1, 4}, {-1, 0, -2});
  file["nodes"][0]["extras"] = {{"vehicle", true}, {"tag", 1}};
  file["nodes"].push_back({{"name", "ground"}, {"mesh", 0}});
  file["scenes"][0] = {{"nodes", {0, 1}}, {"extras", {{"track", {{"radius", 120}}}}}};
  return file;
}

class StageTest : public testing::Test {
protected:
  Staged stage(const json& content, const StageSettings& settings = {}) const {
    return build_stage(folder.file("model.gltf", content.dump()), folder.file("road.gltf", road().dump()),
                       settings);
  }
  ScratchFolder folder;
};

void expect_near(glm::vec3 a, glm::vec3 b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-4f) << i;
}

TEST_F(StageTest, ASceneOfItsOwnStaysAsItIs) {
  const Staged staged = stage(road());
  EXPECT_EQ(staged.track_radius, 120);
  ASSERT_GE(staged.scene.vehicle, 0);
  EXPECT_EQ(staged.scene.nodes.size(), 2u);
}

TEST_F(StageTest, AForeignModelTakesThePlaceOfTheCar) {
  const Staged staged = stage(model({1.8f, 1.2f, 4}, {100, 50, 7}));
  EXPECT_EQ(staged.track_radius, 120);
  expect_near(staged.vehicle.low, {-0.9f, 0, -2});
  expect_near(staged.vehicle.high, {0.9f, 1.2f, 2});
  EXPECT_EQ(std::ranges::count(staged.scene.nodes, "ground", &Node::name), 1);
  EXPECT_EQ(std::ranges::count(staged.scene.nodes, "body", &Node::name), 1);
  for (const Node& node : staged.scene.nodes) EXPECT_EQ(node.tag, node.name == "ground" ? 0 : 1) << node.name;
  EXPECT_EQ(staged.scene.nodes[size_t(staged.scene.vehicle)].parent, -1);
}

TEST_F(StageTest, TagsOfItsOwnAreKept) {
  json tagged = model({1.8f, 1.2f, 4}, {0, 0, 0});
  tagged["nodes"][0]["extras"] = {{"tag", 7}};
  const Staged staged = stage(tagged);
  const auto body = std::ranges::find(staged.scene.nodes, "body", &Node::name);
  EXPECT_EQ(body->tag, 7);
  EXPECT_EQ(staged.scene.nodes[size_t(staged.scene.vehicle)].tag, 0);
}

TEST_F(StageTest, TheLongestSidePointsForward) {
  const Staged staged = stage(model({4, 1.2f, 1.8f}, {0, 0, 0}));
  expect_near(staged.vehicle.high, {0.9f, 1.2f, 2});
}

TEST_F(StageTest, ImplausibleSizesBecomeACars) {
  for (const float size : {0.01f, 400.0f}) {
    const Staged staged = stage(model({size / 2, size / 4, size}, {0, 0, 0}));
    expect_near(staged.vehicle.high, {1.1f, 1.1f, 2.2f});
  }
  expect_near(stage(model({1, 1, 15}, {0, 0, 0})).vehicle.high, {0.5f, 1, 7.5f});
}

TEST_F(StageTest, ScaleAndYawAreSettings) {
  const Staged scaled = stage(model({1, 1, 2}, {0, 0, 0}), {.model_scale = 3});
  expect_near(scaled.vehicle.high, {1.5f, 3, 3});
  const Staged turned = stage(model({1, 1, 2}, {0, 0, 0}), {.model_yaw_deg = 90});
  expect_near(turned.vehicle.high, {1, 1, 0.5f});
}

TEST_F(StageTest, WithoutASurroundingThereIsOnlyTheModel) {
  const Staged staged = stage(model({1, 1, 2}, {0, 0, 0}), {.stage = Stage::none});
  EXPECT_EQ(std::ranges::count(staged.scene.nodes, "ground", &Node::name), 0);
  EXPECT_FALSE(staged.scene.track);
  EXPECT_GE(staged.scene.vehicle, 0);
}

TEST_F(StageTest, SettingsOfAModelAreRefusedForAScene) {
  EXPECT_THROW(stage(road(), {.stage = Stage::none}), SettingError);
  EXPECT_THROW(stage(road(), {.model_scale = 2}), SettingError);
}

TEST_F(StageTest, AnEmptyModelIsAWarning) {
  json empty = model({1, 1, 1}, {0, 0, 0});
  empty["nodes"][0].erase("mesh");
  const Staged staged = stage(empty);
  EXPECT_EQ(std::ranges::count(staged.scene.warnings, "there is nothing in it to draw"), 1);
  EXPECT_EQ(std::ranges::count(staged.scene.nodes, "ground", &Node::name), 1);
}

TEST_F(StageTest, AModelWithoutSizeIsAWarningAndStaysFinite) {
  for (const float scale : {0.0f, 1e-40f}) {
    const Staged staged = stage(model({scale, scale, scale}, {0, 0, 0}));
    EXPECT_EQ(std::ranges::count(staged.scene.warnings, "it has no size, and is drawn as it is"), 1) << scale;
    EXPECT_TRUE(staged.vehicle.empty()) << "the rigs take the usual car";
    for (const glm::dmat4& world : world_matrices(staged.scene, default_pose(staged.scene)))
      for (int i = 0; i < 16; ++i) EXPECT_TRUE(std::isfinite(world[i / 4][i % 4])) << scale;
  }
}

TEST_F(StageTest, WhatIsNoModelIsRefused) {
  try {
    stage(json::object());
    ADD_FAILURE();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.exit, Exit::input_refused);
    EXPECT_NE(std::string(failure.what()).find("model.gltf"), std::string::npos) << failure.what();
  }
}

} // namespace
} // namespace unghost
