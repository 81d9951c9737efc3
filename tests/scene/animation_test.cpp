#include "renderer/scene/animation.h"

#include <cmath>
#include <numbers>

#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

const float half = std::sqrt(0.5f);

/// One node that `values` move at the times 1 and 3.
Trs at(double seconds, Channel channel, Interpolation interpolation, std::vector<glm::vec4> values) {
  Animation animation;
  animation.tracks.push_back({.node = 0,
                              .channel = channel,
                              .interpolation = interpolation,
                              .times = {1, 3},
                              .values = std::move(values)});
  std::vector<Trs> local(1);
  sample(animation, seconds, local);
  return local[0];
}

TEST(Animation, linear_moves_evenly_and_holds_its_ends) {
  const auto x = [](double seconds) {
    return at(seconds, Channel::translation, Interpolation::linear, {{0, 0, 0, 0}, {4, 0, 0, 0}})
        .translation.x;
  };
  EXPECT_FLOAT_EQ(x(0), 0);
  EXPECT_FLOAT_EQ(x(1.5), 1);
  EXPECT_FLOAT_EQ(x(2), 2);
  EXPECT_FLOAT_EQ(x(3), 4);
  EXPECT_FLOAT_EQ(x(9), 4);
}

TEST(Animation, step_jumps_at_its_key) {
  const auto y = [](double seconds) {
    return at(seconds, Channel::scale, Interpolation::step, {{1, 2, 1, 0}, {1, 7, 1, 0}}).scale.y;
  };
  EXPECT_FLOAT_EQ(y(2.999), 2);
  EXPECT_FLOAT_EQ(y(3), 7);
}

TEST(Animation, cubic_splines_follow_hermite) {
  // From 0 leaving with slope 1 to 4 arriving with slope 0 in 2 s. Half way: 0/2 + 2*1/8 + 4/2 - 0 = 2.25.
  const std::vector<glm::vec4> values = {{9, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0},
                                         {0, 0, 0, 0}, {4, 0, 0, 0}, {9, 0, 0, 0}};
  const auto x = [&](double seconds) {
    return at(seconds, Channel::translation, Interpolation::cubic_spline, values).translation.x;
  };
  EXPECT_FLOAT_EQ(x(0), 0);
  EXPECT_FLOAT_EQ(x(2), 2.25f);
  // A quarter: t=.25: h10=(t3-2t2+t)=.140625, h01=3t2-2t3=.15625: 2*.140625 + 4*.15625 = .90625
  EXPECT_FLOAT_EQ(x(1.5), 0.90625f);
  EXPECT_FLOAT_EQ(x(5), 4);
}

TEST(Animation, rotations_take_the_shortest_arc_at_an_even_pace) {
  // From none to a quarter turn about z, the second key with its sign turned round.
  const std::vector<glm::vec4> values = {{0, 0, 0, 1}, {0, 0, -half, -half}};
  for (const double part : {0.25, 0.5, 0.75}) {
    const glm::quat q = at(1 + 2 * part, Channel::rotation, Interpolation::linear, values).rotation;
    const glm::vec3 turned = q * glm::vec3(1, 0, 0);
    const double angle = part * std::numbers::pi / 2;
    expect_near(turned, glm::vec3(std::cos(angle), std::sin(angle), 0));
  }
}

TEST(Animation, cubic_rotations_come_out_with_length_one) {
  const std::vector<glm::vec4> values = {{0, 0, 0, 0}, {0, 0, 0, 1}, {0, 0, 1, 0},
                                         {0, 0, 1, 0}, {0, 0, 1, 0}, {0, 0, 0, 0}};
  const glm::quat q = at(2, Channel::rotation, Interpolation::cubic_spline, values).rotation;
  EXPECT_NEAR(glm::length(q), 1, 1e-6);
}

TEST(Animation, world_matrices_are_parent_times_local_in_double_precision) {
  Scene scene;
  scene.nodes.resize(3);
  scene.nodes[0].local.translation = {1e6f, 0, 0};
  scene.nodes[0].local.rotation = glm::quat(half, 0, half, 0); // a quarter turn about y: z becomes x
  scene.nodes[1].parent = 0;
  scene.nodes[1].local.translation = {0, 0, 0.001f};
  scene.nodes[1].local.scale = glm::vec3(2);
  scene.nodes[2].parent = 1;
  scene.nodes[2].matrix = glm::mat4(1);
  (*scene.nodes[2].matrix)[3] = {0, 3, 0, 1};
  const std::vector<glm::dmat4> world = world_matrices(scene, default_pose(scene));
  EXPECT_NEAR(world[1][3].x, 1e6 + 0.001, 1e-8);
  EXPECT_NEAR(world[2][3].y, 6, 1e-12);
  EXPECT_NEAR(world[2][3].x, 1e6 + 0.001, 1e-8);
}

/// A document whose only node moves; `more` goes into the sampler.
Document moving(const std::vector<float>& times, const std::vector<float>& values,
                Json more = Json::object()) {
  Document document;
  document.triangle();
  Json sampler = {{"input", document.floats(times, "SCALAR")}, {"output", document.floats(values, "VEC3")}};
  sampler.update(more);
  const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}};
  document.json["animations"] = {
      {{"name", "go"}, {"samplers", Json::array({sampler})}, {"channels", Json::array({channel})}}};
  return document;
}

TEST(Animation, tracks_are_read_from_a_file) {
  const Scene scene = scene_of(moving({0, 2}, {0, 0, 0, 1, 2, 3}, {{"interpolation", "STEP"}}));
  ASSERT_EQ(scene.animations.size(), 1u);
  EXPECT_EQ(scene.animations[0].name, "go");
  EXPECT_FLOAT_EQ(scene.animations[0].duration, 2);
  ASSERT_EQ(scene.animations[0].tracks.size(), 1u);
  EXPECT_EQ(scene.animations[0].tracks[0].interpolation, Interpolation::step);
  EXPECT_EQ(scene.animations[0].tracks[0].values[1], glm::vec4(1, 2, 3, 0));
}

TEST(Animation, broken_tracks_are_refused) {
  EXPECT_NE(refusal_of(moving({2, 1}, {0, 0, 0, 0, 0, 0})).why.find("ascend"), std::string::npos);
  EXPECT_NE(refusal_of(moving({0, INFINITY}, {0, 0, 0, 0, 0, 0})).why.find("finite"), std::string::npos);
  EXPECT_NE(refusal_of(moving({0, 1}, {0, 0, 0})).why.find("1 values for 2 keys"), std::string::npos);
  EXPECT_NE(
      refusal_of(moving({0, 1}, {0, 0, 0, 0, 0, 0}, {{"interpolation", "CUBICSPLINE"}})).why.find("2 keys"),
      std::string::npos);
  EXPECT_EQ(refusal_of(moving({0}, {0, 0, 0}, {{"interpolation", "WOBBLE"}})).pointer,
            "/animations/0/samplers/0/interpolation");
  Document document = moving({0}, {0, 0, 0});
  document.json["animations"][0]["channels"][0]["sampler"] = 5;
  EXPECT_NE(refusal_of(document).why.find("no such sampler"), std::string::npos);
}

TEST(Animation, weights_and_nodes_with_a_matrix_are_said_and_left_out) {
  Document document = moving({0}, {0, 0, 0});
  document.json["animations"][0]["channels"][0]["target"]["path"] = "weights";
  EXPECT_TRUE(warns_of(scene_of(document), "morph weights"));
  document = moving({0}, {0, 0, 0});
  document.json["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const Scene scene = scene_of(document);
  EXPECT_TRUE(warns_of(scene, "matrix"));
  EXPECT_TRUE(scene.animations.empty());
}

} // namespace
} // namespace unghost::test
