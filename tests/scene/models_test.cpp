// Real models of other people. UNGHOST_MODELS names their folder; its index.json says what to expect of each.
#include <chrono>
#include <cmath>
#include <cstdlib>

#include "renderer/scene/bounds.h"
#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

struct Models {
  std::filesystem::path folder;
  Json index;
};

std::optional<Models> models() {
  const char* folder = std::getenv("UNGHOST_MODELS");
  if (!folder) return std::nullopt;
  std::ifstream file(std::filesystem::path(folder) / "index.json");
  return Models{folder, Json::parse(file)};
}

#define NEED_MODELS(name)                                                                                    \
  const std::optional<Models> name = models();                                                               \
  if (!name) GTEST_SKIP() << "UNGHOST_MODELS does not name a folder of models"

/// What everybody who draws a scene takes for granted.
void expect_sound(const Scene& scene) {
  ASSERT_FALSE(scene.materials.empty());
  for (const Mesh& mesh : scene.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      ASSERT_LT(size_t(primitive.material), scene.materials.size());
      ASSERT_EQ(primitive.index_count % 3, 0u);
      ASSERT_LE(size_t(primitive.first_index) + primitive.index_count, scene.indices.size());
      ASSERT_LE(size_t(primitive.first_vertex) + primitive.vertex_count, scene.vertices.size());
      for (uint32_t i = 0; i < primitive.index_count; ++i) {
        ASSERT_LT(scene.indices[primitive.first_index + i], primitive.vertex_count);
      }
    }
  }
  for (const Vertex& vertex : scene.vertices) {
    ASSERT_TRUE(std::isfinite(glm::dot(vertex.position, vertex.position)));
    ASSERT_NEAR(glm::length(vertex.normal), 1, 1e-3);
    ASSERT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 1e-3);
    ASSERT_EQ(std::abs(vertex.tangent.w), 1);
  }
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    ASSERT_LT(scene.nodes[i].parent, int(i));
    ASSERT_LT(scene.nodes[i].mesh, int(scene.meshes.size()));
  }
  for (const Image& image : scene.images)
    ASSERT_EQ(image.rgba.size(), size_t(image.width) * image.height * 4);
}

Loaded load_in_time(const std::filesystem::path& file) {
  const auto start = std::chrono::steady_clock::now();
  Loaded loaded = load_scene(file);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 10) << file;
  if (const auto* scene = std::get_if<Scene>(&loaded)) {
    SCOPED_TRACE(file);
    expect_sound(*scene);
  } else {
    EXPECT_GT(std::get<Refusal>(loaded).sentence().size(), file.string().size() + 10);
  }
  return loaded;
}

bool needs_an_extension(const Loaded& loaded) {
  const auto* refusal = std::get_if<Refusal>(&loaded);
  return refusal && refusal->why.starts_with("needs the extension ");
}

TEST(Models, valid_ones_load_or_need_an_extension_that_is_named) {
  NEED_MODELS(all);
  int loaded_count = 0;
  std::vector<std::string> refused;
  for (const Json& entry : all->index) {
    if (entry["kind"] != "valid") continue;
    const Loaded loaded = load_in_time(all->folder / entry["path"].get<std::string>());
    if (std::holds_alternative<Scene>(loaded)) {
      ++loaded_count;
    } else {
      EXPECT_TRUE(needs_an_extension(loaded)) << std::get<Refusal>(loaded).sentence();
      refused.push_back(std::get<Refusal>(loaded).sentence());
    }
  }
  EXPECT_GT(loaded_count, 150);
  EXPECT_LE(refused.size(), 6u) << Json(refused).dump(1);
}

TEST(Models, what_a_loader_should_reject_is_refused) {
  NEED_MODELS(all);
  for (const Json& entry : all->index) {
    if (entry["should_reject"] != true) continue;
    const Loaded loaded = load_in_time(all->folder / entry["path"].get<std::string>());
    EXPECT_TRUE(std::holds_alternative<Refusal>(loaded)) << entry["path"];
  }
}

TEST(Models, the_rest_ends_in_a_scene_or_a_sentence) {
  NEED_MODELS(all);
  for (const Json& entry : all->index) {
    if (entry["kind"] != "hdri") load_in_time(all->folder / entry["path"].get<std::string>());
  }
}

TEST(Models, features_that_are_not_drawn_are_said) {
  NEED_MODELS(all);
  const std::pair<const char*, const char*> expected[] = {
      {"valid/CesiumMan-binary/CesiumMan.glb", "skins"},
      {"valid/SimpleSkin-embedded/SimpleSkin.gltf", "skins"},
      {"valid/greenman/greenman.glb", "skins"},
      {"valid/AnimatedMorphCube/AnimatedMorphCube.gltf", "morph targets"},
      {"valid/SimpleMorph/SimpleMorph.gltf", "morph weights"},
      {"valid/Cameras/Cameras.gltf", "orthographic"},
      {"valid/blender-io-19_sheen/19_sheen.gltf", "KHR_materials_sheen"},
      {"valid/asset-generator/Mesh_PrimitiveMode/Mesh_PrimitiveMode_01.gltf", "points and lines"},
  };
  for (const auto& [path, word] : expected) {
    const Scene scene = scene_of(load_scene(all->folder / path));
    EXPECT_TRUE(warns_of(scene, word)) << path;
  }
}

TEST(Models, a_car_has_four_wheels_and_two_of_them_steer) {
  NEED_MODELS(all);
  for (const char* name : {"sedan-sports", "sedan", "police", "suv", "hatchback-sports"}) {
    const auto file = all->folder / "valid/kenney-car-kit" / (std::string(name) + ".glb");
    const Scene scene = scene_of(load_scene(file));
    int wheels = 0, steering = 0;
    for (const Node& node : scene.nodes) {
      if (!node.wheel) continue;
      ++wheels;
      steering += node.wheel->steers;
      EXPECT_NEAR(node.wheel->radius, node.local.translation.y, 0.02) << name; // it stands on the ground
      EXPECT_EQ(node.wheel->steers, node.local.translation.z > 0);
    }
    EXPECT_EQ(wheels, 4) << name;
    EXPECT_EQ(steering, 2) << name;
    EXPECT_NEAR(scene_bounds(scene).low.y, 0, 0.02);
  }
}

} // namespace
} // namespace unghost::test
