#include "renderer/scene/bounds.h"
#include "renderer/scene/wheels.h"
#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

int node_named(const Scene& scene, const std::string& name) {
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].name == name) return int(i);
  }
  ADD_FAILURE() << "no node " << name;
  return 0;
}

TEST(Nodes, parents_come_before_children_whatever_the_file_says) {
  Document document;
  document.json["nodes"] = {{{"name", "leaf"}},
                            {{"name", "branch"}, {"children", {0}}},
                            {{"name", "root"}, {"children", {1, 3}}},
                            {{"name", "other"}}};
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.nodes.size(), 4u);
  for (size_t i = 0; i < scene.nodes.size(); ++i) EXPECT_LT(scene.nodes[i].parent, int(i));
  EXPECT_EQ(scene.nodes[size_t(node_named(scene, "leaf"))].parent, node_named(scene, "branch"));
  EXPECT_EQ(scene.nodes[size_t(node_named(scene, "root"))].parent, -1);
}

TEST(Nodes, only_the_default_scene_is_read) {
  Document document;
  document.json["nodes"] = {{{"name", "a"}}, {{"name", "b"}}, {{"name", "below b"}}};
  document.json["nodes"][1]["children"] = {2};
  document.json["scenes"] = {{{"nodes", {0}}}, {{"name", "second"}, {"nodes", {1}}}};
  document.json["scene"] = 1;
  const Scene scene = scene_of(document);
  EXPECT_EQ(scene.nodes.size(), 2u);
  EXPECT_EQ(scene.name, "second");
  document.json.erase("scene");
  EXPECT_EQ(scene_of(document).nodes.size(), 1u);
  document.json.erase("scenes");
  EXPECT_EQ(scene_of(document).nodes.size(), 3u);
}

TEST(Nodes, a_graph_that_is_no_forest_is_refused) {
  Document document;
  document.json["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}};
  EXPECT_NE(refusal_of(document).why.find("two parents"), std::string::npos);
  document.json["nodes"] = {Json::object(), {{"children", {2}}}, {{"children", {1}}}};
  EXPECT_EQ(refusal_of(document).pointer, "/nodes/1");
  document.json["nodes"] = {{{"children", {1}}}, Json::object()};
  document.json["scenes"] = {{{"nodes", {1}}}};
  EXPECT_NE(refusal_of(document).why.find("child of another"), std::string::npos);
}

TEST(Nodes, transforms_are_read_and_quaternions_made_whole) {
  Document document;
  document.json["nodes"] = {{{"rotation", {0, 0, 0, 0}}, {"scale", {1, 2, 3}}},
                            {{"rotation", {0, 3, 0, 4}}, {"translation", {5, 6, 7}}},
                            {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 8, 9, 10, 1}}}};
  const Scene scene = scene_of(document);
  EXPECT_EQ(scene.nodes[0].local.rotation, glm::quat(1, 0, 0, 0));
  EXPECT_EQ(scene.nodes[0].local.scale, glm::vec3(1, 2, 3));
  EXPECT_FLOAT_EQ(scene.nodes[1].local.rotation.y, 0.6f);
  EXPECT_FLOAT_EQ(scene.nodes[1].local.rotation.w, 0.8f);
  ASSERT_TRUE(scene.nodes[2].matrix);
  EXPECT_EQ((*scene.nodes[2].matrix)[3], glm::vec4(8, 9, 10, 1));
}

TEST(Nodes, extras_tag_vehicle_wheels_and_track) {
  Document document;
  document.json["nodes"] = {{{"children", {1, 2}}, {"extras", {{"tag", 7}, {"vehicle", true}}}},
                            {{"extras", {{"wheel", {{"radius", 0.33}, {"steers", true}}}}}},
                            {{"extras", {{"tag", 9}}}}};
  document.json["scenes"] = {{{"nodes", {0}}, {"extras", {{"track", {{"radius", 55.5}}}}}}};
  const Scene scene = scene_of(document);
  EXPECT_EQ(scene.vehicle, 0);
  EXPECT_EQ(scene.nodes[0].tag, 7);
  EXPECT_EQ(scene.nodes[1].tag, 7);
  EXPECT_EQ(scene.nodes[2].tag, 9);
  ASSERT_TRUE(scene.nodes[1].wheel);
  EXPECT_FLOAT_EQ(scene.nodes[1].wheel->radius, 0.33f);
  EXPECT_TRUE(scene.nodes[1].wheel->steers);
  ASSERT_TRUE(scene.track);
  EXPECT_FLOAT_EQ(scene.track->radius, 55.5f);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Nodes, extras_of_a_wrong_type_are_said_and_ignored) {
  for (const Json& extras : {Json{{"tag", 256}}, Json{{"tag", 0}}, Json{{"tag", "red"}}, Json{{"tag", 1.5}},
                             Json{{"vehicle", 1}}, Json{{"wheel", true}}, Json{{"wheel", {{"radius", -1}}}},
                             Json{{"wheel", {{"radius", 1}, {"steers", 2}}}}}) {
    Document document;
    document.json["nodes"] = {{{"extras", extras}}};
    const Scene scene = scene_of(document);
    EXPECT_EQ(scene.warnings.size(), 1u) << extras;
    EXPECT_EQ(scene.nodes[0].tag, 0);
    EXPECT_FALSE(scene.nodes[0].wheel);
    EXPECT_EQ(scene.vehicle, -1);
  }
  Document document;
  document.json["scenes"] = {{{"extras", {{"track", 12}}}}};
  EXPECT_TRUE(warns_of(scene_of(document), "extras.track"));
  document.json["scenes"] = {{{"extras", "a word"}}};
  EXPECT_TRUE(scene_of(document).warnings.empty());
}

TEST(Wheels, names) {
  EXPECT_TRUE(is_wheel_name("wheel-front-left"));
  EXPECT_TRUE(is_wheel_name("Front_Wheel.L"));
  EXPECT_FALSE(is_wheel_name("Steering Wheel"));
  EXPECT_FALSE(is_wheel_name("WheelArch_FL"));
  EXPECT_FALSE(is_wheel_name("body"));
}

/// A mesh whose box is `size`, round the origin.
int box(Document& document, glm::vec3 size) {
  const glm::vec3 h = size / 2.0f;
  const int positions = document.floats({-h.x, -h.y, -h.z, h.x, h.y, h.z, h.x, -h.y, h.z}, "VEC3");
  return document.add("meshes", {{"primitives", Json::array({{{"attributes", {{"POSITION", positions}}}}})}});
}

TEST(Wheels, are_found_by_name_where_no_extras_say_them) {
  Document document;
  const int tyre = box(document, {0.2f, 0.6f, 0.6f}), axle = box(document, {0.6f, 0.6f, 2});
  document.json["nodes"] = {{{"name", "Wheels"}, {"children", {1, 2}}, {"scale", {2, 2, 2}}},
                            {{"name", "wheel back"}, {"translation", {0, 0, 3}}, {"children", {3}}},
                            {{"name", "wheel front"}, {"mesh", tyre}, {"rotation", {0.38, 0, 0, 0.92}}},
                            {{"name", "wheel back mesh"}, {"mesh", tyre}},
                            {{"name", "steering wheel"}, {"mesh", tyre}},
                            {{"name", "wheels on their axle"}, {"mesh", axle}}};
  Scene scene = scene_of(document);
  const auto wheel = [&](const char* name) { return scene.nodes[size_t(node_named(scene, name))].wheel; };
  EXPECT_FALSE(wheel("Wheels"));
  ASSERT_TRUE(wheel("wheel back"));
  EXPECT_FLOAT_EQ(wheel("wheel back")->radius, 0.3f);
  EXPECT_FALSE(wheel("wheel back")->steers);
  EXPECT_FALSE(wheel("wheel back mesh"));
  ASSERT_TRUE(wheel("wheel front"));
  EXPECT_FLOAT_EQ(wheel("wheel front")->radius, 0.3f);
  EXPECT_TRUE(wheel("wheel front")->steers);
  EXPECT_FALSE(wheel("steering wheel"));
  EXPECT_FALSE(wheel("wheels on their axle"));
  EXPECT_TRUE(warns_of(scene, "not round"));

  document.json["nodes"][4]["extras"] = {{"wheel", {{"radius", 1}}}};
  scene = scene_of(document);
  EXPECT_FALSE(wheel("wheel front"));
  EXPECT_TRUE(wheel("steering wheel"));
}

TEST(Wheels, without_front_in_a_name_the_greater_z_steers) {
  Document document;
  const int tyre = box(document, {0.2f, 0.6f, 0.6f});
  document.json["nodes"] = {{{"name", "wheel1"}, {"mesh", tyre}, {"translation", {0, 0, -1}}},
                            {{"name", "wheel2"}, {"mesh", tyre}, {"translation", {0, 0, 1.5}}}};
  const Scene scene = scene_of(document);
  EXPECT_FALSE(scene.nodes[0].wheel.value().steers);
  EXPECT_TRUE(scene.nodes[1].wheel.value().steers);
}

TEST(Wheels, a_matrix_is_taken_apart_so_that_they_can_turn_unless_it_is_more) {
  Document document;
  const int tyre = box(document, {0.2f, 0.6f, 0.6f});
  // a quarter turn about x, twice as large, 3 m ahead; and one that shears
  document.json["nodes"] = {
      {{"name", "wheel front"},
       {"mesh", tyre},
       {"matrix", {2, 0, 0, 0, 0, 0, 2, 0, 0, -2, 0, 0, 0, 0, 3, 1}}},
      {{"name", "wheel back"}, {"mesh", tyre}, {"matrix", {1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}};
  const Scene scene = scene_of(document);
  const Node &front = scene.nodes[0], &back = scene.nodes[1];
  ASSERT_TRUE(front.wheel);
  EXPECT_FLOAT_EQ(front.wheel->radius, 0.6f);
  EXPECT_FALSE(front.matrix);
  EXPECT_NEAR(front.local.rotation.x, std::sqrt(0.5), 1e-6);
  EXPECT_EQ(front.local.translation, glm::vec3(0, 0, 3));
  EXPECT_TRUE(back.matrix);
}

TEST(Bounds, of_a_scene_and_of_a_subtree) {
  Document document;
  const int mesh = box(document, {2, 2, 2});
  document.json["nodes"] = {{{"translation", {10, 0, 0}}, {"children", {1}}},
                            {{"mesh", mesh}, {"scale", {1, 3, 1}}},
                            {{"mesh", mesh}, {"translation", {0, 0, -5}}}};
  const Scene scene = scene_of(document);
  expect_near(scene_bounds(scene).low, {-1, -3, -6});
  expect_near(scene_bounds(scene).high, {11, 3, 1});
  expect_near(node_bounds(scene, 0).low, {9, -3, -1});
  expect_near(node_bounds(scene, 0).high, {11, 3, 1});
  EXPECT_TRUE(scene_bounds(Scene{}).empty());
}

TEST(CamerasAndLights, are_read) {
  Document document;
  document.json["cameras"] = {
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.2}}}},
      {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"zfar", 9}, {"znear", 0.1}}}}};
  document.json["extensionsUsed"] = {"KHR_lights_punctual"};
  const Json spot = {{"type", "spot"},
                     {"color", {1, 0.5, 0}},
                     {"intensity", 4},
                     {"range", 3},
                     {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.3}}}};
  document.json["extensions"]["KHR_lights_punctual"]["lights"] =
      Json::array({{{"type", "directional"}}, spot});
  document.json["nodes"] = {{{"camera", 1}}, {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}}};
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.cameras.size(), 2u);
  EXPECT_FLOAT_EQ(scene.cameras[0].vertical_fov, 0.5f);
  EXPECT_FLOAT_EQ(scene.cameras[0].near_plane, 0.2f);
  EXPECT_EQ(scene.nodes[0].camera, 1);
  EXPECT_TRUE(warns_of(scene, "orthographic"));
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].kind, LightKind::directional);
  EXPECT_EQ(scene.lights[1].intensity, glm::vec3(4, 2, 0));
  EXPECT_FLOAT_EQ(scene.lights[1].outer_cone, 0.3f);
  EXPECT_EQ(scene.nodes[0].light, -1);
  EXPECT_EQ(scene.nodes[1].light, 1);
}

} // namespace
} // namespace unghost::test
