#include "renderer/scene/merge.h"

#include "renderer/scene/bounds.h"
#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

/// A node at `x` with a mesh, a texture, an animation, and a name for its material.
Scene part(const std::string& name, float x, bool is_vehicle) {
  Document document;
  Json& primitive = document.triangle();
  primitive["material"] = 0;
  document.json["materials"] = {
      {{"name", name}, {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  document.json["textures"] = {{{"source", 0}}};
  document.json["images"] = {{{"name", name}, {"uri", name + ".png"}}};
  Json& node = document.json["nodes"][0];
  node["name"] = name, node["translation"] = {x, 0, 0};
  if (is_vehicle) node["extras"] = {{"vehicle", true}, {"tag", 3}};
  const Json sampler = {{"input", document.floats({0, x}, "SCALAR")},
                        {"output", document.floats({0, 0, 0, 1, 1, 1}, "VEC3")}};
  const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}};
  document.json["animations"] = {
      {{"samplers", Json::array({sampler})}, {"channels", Json::array({channel})}}};
  return scene_of(document);
}

void expect_whole(const Scene& scene) {
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    EXPECT_LT(scene.nodes[i].parent, int(i));
    EXPECT_LT(scene.nodes[i].mesh, int(scene.meshes.size()));
  }
  for (const Mesh& mesh : scene.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      ASSERT_LT(size_t(primitive.material), scene.materials.size());
      ASSERT_LE(primitive.first_index + primitive.index_count, scene.indices.size());
      ASSERT_LE(primitive.first_vertex + primitive.vertex_count, scene.vertices.size());
      for (uint32_t i = 0; i < primitive.index_count; ++i) {
        EXPECT_LT(scene.indices[primitive.first_index + i], primitive.vertex_count);
      }
    }
  }
  for (const Material& material : scene.materials) {
    EXPECT_LT(material.base_colour_texture.image, int(scene.images.size()));
  }
  for (const Animation& animation : scene.animations) {
    for (const AnimationTrack& track : animation.tracks) EXPECT_LT(track.node, int(scene.nodes.size()));
  }
}

TEST(Merge, append_keeps_every_reference) {
  Scene scene = part("road", 1, false);
  const Scene car = part("car", 10, true);
  const int first = append(scene, car, 0);
  EXPECT_EQ(first, 1);
  expect_whole(scene);
  EXPECT_EQ(scene.nodes[1].parent, 0);
  EXPECT_EQ(scene.vehicle, 1);
  EXPECT_EQ(scene.nodes[1].tag, 3);
  const Mesh& mesh = scene.meshes[size_t(scene.nodes[1].mesh)];
  const Material& material = scene.materials[size_t(mesh.primitives[0].material)];
  EXPECT_EQ(material.name, "car");
  EXPECT_EQ(scene.images[size_t(material.base_colour_texture.image)].name, "car");
  EXPECT_EQ(scene.animations.at(1).tracks[0].node, 1);
  expect_near(node_bounds(scene, 1).low, {11, 0, 0}); // under the road at x = 1
}

TEST(Merge, appended_nodes_inherit_a_tag) {
  Scene scene = part("car", 1, true);
  append(scene, part("luggage", 2, false), 0);
  EXPECT_EQ(scene.nodes[1].tag, 3);
  EXPECT_EQ(scene.vehicle, 0);
}

TEST(Merge, without_drops_a_subtree_and_what_only_it_used) {
  const Scene road = part("road", 1, false);
  Scene scene = part("car", 10, true);
  append(scene, part("luggage", 2, false), 0);
  append(scene, road, -1);
  const Scene kept = without(scene, 0);
  expect_whole(kept);
  ASSERT_EQ(kept.nodes.size(), 1u);
  EXPECT_EQ(kept.nodes[0].name, "road");
  EXPECT_EQ(kept.vehicle, -1);
  EXPECT_EQ(kept.vertices.size(), road.vertices.size());
  EXPECT_EQ(kept.indices, road.indices);
  ASSERT_EQ(kept.images.size(), 1u);
  EXPECT_EQ(kept.images[0].name, "road");
  ASSERT_EQ(kept.materials.size(), 1u);
  EXPECT_EQ(kept.materials[0].name, "road");
  ASSERT_EQ(kept.animations.size(), 1u);
  EXPECT_EQ(kept.animations[0].tracks[0].node, 0);
  EXPECT_FLOAT_EQ(kept.animations[0].duration, 1);
}

TEST(Merge, without_everything_still_has_a_material) {
  const Scene kept = without(part("car", 1, true), 0);
  EXPECT_TRUE(kept.nodes.empty());
  EXPECT_TRUE(kept.vertices.empty());
  EXPECT_EQ(kept.materials.size(), 1u);
}

} // namespace
} // namespace unghost::test
