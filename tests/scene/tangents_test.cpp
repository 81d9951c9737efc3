#include "renderer/scene/tangents.h"

#include <cmath>

#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

Vertex corner(glm::vec3 position, glm::vec2 uv, glm::vec3 normal = {0, 0, 1}) {
  Vertex vertex;
  vertex.position = position, vertex.normal = normal, vertex.uv0 = uv;
  return vertex;
}

void expect_frames(const std::vector<Vertex>& vertices) {
  for (const Vertex& vertex : vertices) {
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 1e-5);
    EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0, 1e-5);
    EXPECT_EQ(std::abs(vertex.tangent.w), 1);
  }
}

TEST(Tangents, point_where_u_grows) {
  // u grows along +y, v along -x: tangent (0,1,0), and n x t = (-1,0,0) is where v grows
  std::vector<Vertex> vertices = {corner({0, 0, 0}, {0, 0}), corner({0, 1, 0}, {1, 0}),
                                  corner({-1, 0, 0}, {0, 1})};
  std::vector<uint32_t> indices = {0, 1, 2};
  make_tangents(vertices, indices, {});
  expect_frames(vertices);
  expect_near(glm::vec3(vertices[0].tangent), {0, 1, 0});
  EXPECT_EQ(vertices[0].tangent.w, 1);
}

TEST(Tangents, are_orthogonal_to_slanted_normals) {
  const glm::vec3 slanted = glm::normalize(glm::vec3(1, 0, 1));
  std::vector<Vertex> vertices = {corner({0, 0, 0}, {0, 0}, slanted), corner({1, 0, 0}, {1, 0}, slanted),
                                  corner({0, 1, 0}, {0, 1}, slanted)};
  std::vector<uint32_t> indices = {0, 1, 2};
  make_tangents(vertices, indices, {});
  expect_frames(vertices);
  expect_near(glm::vec3(vertices[1].tangent), glm::normalize(glm::vec3(1, 0, -1)));
}

TEST(Tangents, a_mirrored_seam_is_split_and_keeps_both_signs) {
  // Two triangles on either side of x = 0, the texture mirrored about the seam.
  std::vector<Vertex> vertices = {corner({0, 0, 0}, {0, 0}), corner({0, 1, 0}, {0, 1}),
                                  corner({1, 0, 0}, {1, 0}), corner({-1, 0, 0}, {1, 0})};
  std::vector<uint32_t> indices = {0, 2, 1, 0, 1, 3};
  make_tangents(vertices, indices, {});
  expect_frames(vertices);
  ASSERT_EQ(vertices.size(), 6u);
  for (int i = 0; i < 3; ++i) {
    const glm::vec4 right = vertices[indices[size_t(i)]].tangent,
                    left = vertices[indices[size_t(3 + i)]].tangent;
    expect_near(glm::vec3(right), {1, 0, 0});
    expect_near(glm::vec3(left), {-1, 0, 0});
    EXPECT_EQ(right.w, 1);
    EXPECT_EQ(left.w, -1);
  }
}

TEST(Tangents, degenerate_coordinates_get_some_frame) {
  std::vector<Vertex> vertices = {corner({0, 0, 0}, {.5f, .5f}), corner({1, 0, 0}, {.5f, .5f}),
                                  corner({0, 1, 0}, {.5f, .5f}, {1, 0, 0})};
  std::vector<uint32_t> indices = {0, 1, 2};
  make_tangents(vertices, indices, {});
  expect_frames(vertices);
}

TEST(Tangents, follow_the_uv_set_and_transform_of_the_normal_map) {
  std::vector<Vertex> vertices = {corner({0, 0, 0}, {0, 0}), corner({1, 0, 0}, {0, 0}),
                                  corner({0, 1, 0}, {0, 0})};
  vertices[1].uv1 = {1, 0}, vertices[2].uv1 = {0, 1};
  TextureUse use;
  use.uv_set = 1;
  use.transform = glm::mat3x2(0, 1, -1, 0, 0, 0); // u' = -v: grows along -y
  std::vector<uint32_t> indices = {0, 1, 2};
  make_tangents(vertices, indices, use);
  expect_near(glm::vec3(vertices[0].tangent), {0, -1, 0});
}

TEST(Tangents, perpendicular_is_one_for_any_normal) {
  for (const glm::vec3 n :
       {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, -1), glm::vec3(-1, 0, 0)}) {
    EXPECT_NEAR(glm::dot(perpendicular_to(n), n), 0, 1e-6);
    EXPECT_NEAR(glm::length(perpendicular_to(n)), 1, 1e-6);
  }
}

TEST(Tangents, are_made_where_a_normal_map_wants_them_and_only_there) {
  Document document;
  Json& primitive = document.triangle();
  primitive["attributes"]["NORMAL"] = document.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  primitive["attributes"]["TEXCOORD_0"] = document.floats({0, 0, 0, 1, 1, 0}, "VEC2");
  primitive["material"] = 0;
  document.json["textures"] = {Json::object()};
  document.json["materials"] = {{{"normalTexture", {{"index", 0}}}}};
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.vertices.size(), 3u);
  expect_near(glm::vec3(scene.vertices[0].tangent), {0, 1, 0}); // u grows along y
  EXPECT_EQ(scene.vertices[0].tangent.w, -1);
}

} // namespace
} // namespace unghost::test
