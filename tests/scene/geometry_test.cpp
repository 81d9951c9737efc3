#include "tests/scene/gltf_document.h"

namespace unghost::test {
namespace {

TEST(Geometry, a_plain_triangle_arrives_as_it_is) {
  Document document;
  document.triangle();
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.indices, (std::vector<uint32_t>{0, 1, 2}));
  ASSERT_EQ(scene.vertices.size(), 3u);
  expect_near(scene.vertices[1].position, {1, 0, 0});
  EXPECT_EQ(scene.meshes[0].primitives[0].bounds.high, glm::vec3(1, 1, 0));
  EXPECT_EQ(scene.materials.size(), 1u);
  EXPECT_EQ(scene.meshes[0].primitives[0].material, 0);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST(Geometry, a_glb_says_the_same_as_its_gltf) {
  Document document;
  document.triangle();
  const TempFolder folder;
  const Scene scene = scene_of(load_scene(folder.write("scene.glb", document.glb())));
  ASSERT_EQ(scene.vertices.size(), 3u);
  expect_near(scene.vertices[2].position, {0, 1, 0});
}

/// x of the first corner of each triangle and so on: positions are (i, i*i, 0), so corners can be told.
std::vector<int> corners_of(int mode, bool indexed) {
  Document document;
  std::vector<float> positions;
  for (int i = 0; i < 5; ++i) positions.insert(positions.end(), {float(i), float(i * i), 0});
  Json primitive = {{"mode", mode}, {"attributes", {{"POSITION", document.floats(positions, "VEC3")}}}};
  primitive["attributes"]["NORMAL"] = document.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3");
  if (indexed) primitive["indices"] = document.shorts({4, 3, 2, 1, 0});
  document.drawn(primitive);
  const Scene scene = scene_of(document);
  std::vector<int> corners;
  for (const uint32_t index : scene.indices) corners.push_back(int(scene.vertices[index].position.x));
  return corners;
}

TEST(Geometry, strips_and_fans_become_lists_with_their_winding) {
  EXPECT_EQ(corners_of(5, false), (std::vector<int>{0, 1, 2, 1, 3, 2, 2, 3, 4}));
  EXPECT_EQ(corners_of(6, false), (std::vector<int>{1, 2, 0, 2, 3, 0, 3, 4, 0}));
  EXPECT_EQ(corners_of(5, true), (std::vector<int>{4, 3, 2, 3, 1, 2, 2, 1, 0}));
  EXPECT_EQ(corners_of(4, false), (std::vector<int>{0, 1, 2})); // two are left over
}

TEST(Geometry, points_and_lines_are_left_out_and_said_once) {
  Document document;
  for (int mode = 0; mode < 4; ++mode) document.triangle()["mode"] = mode;
  const Scene scene = scene_of(document);
  EXPECT_TRUE(scene.indices.empty());
  EXPECT_EQ(scene.warnings.size(), 1u);
  EXPECT_TRUE(warns_of(scene, "points and lines"));
}

TEST(Geometry, indices_of_all_widths_are_read) {
  for (const int component : {5121, 5123, 5125}) {
    Document document;
    Json& primitive = document.triangle();
    int indices = 0;
    if (component == 5121) indices = document.accessor<uint8_t>({2, 0, 1}, "SCALAR", component);
    if (component == 5123) indices = document.accessor<uint16_t>({2, 0, 1}, "SCALAR", component);
    if (component == 5125) indices = document.accessor<uint32_t>({2, 0, 1}, "SCALAR", component);
    primitive["indices"] = indices;
    const Scene scene = scene_of(document);
    ASSERT_EQ(scene.indices.size(), 3u);
    expect_near(scene.vertices[scene.indices[0]].position, {0, 1, 0});
  }
}

TEST(Geometry, sparse_accessors_replace_elements) {
  Document document;
  const int places = document.view(bytes_of(std::vector<uint16_t>{1}));
  const int values = document.view(bytes_of(std::vector<float>{5, 6, 7}));
  const Json sparse = {{"sparse",
                        {{"count", 1},
                         {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                         {"values", {{"bufferView", values}}}}}};
  const int positions = document.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 5126, sparse);
  document.drawn({{"attributes", {{"POSITION", positions}}}});
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.vertices.size(), 3u);
  expect_near(scene.vertices[0].position, {0, 0, 0});
  expect_near(scene.vertices[1].position, {5, 6, 7});
  expect_near(scene.vertices[2].position, {0, 1, 0});
}

TEST(Geometry, sparse_indices_must_ascend_and_stay_inside) {
  for (const std::vector<uint16_t>& bad : {std::vector<uint16_t>{1, 1}, {2, 1}, {0, 3}}) {
    Document document;
    const Json sparse = {
        {"sparse",
         {{"count", 2},
          {"indices", {{"bufferView", document.view(bytes_of(bad))}, {"componentType", 5123}}},
          {"values", {{"bufferView", document.view(Bytes(24))}}}}}};
    const int positions = document.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 5126, sparse);
    document.drawn({{"attributes", {{"POSITION", positions}}}});
    EXPECT_NE(refusal_of(document).why.find("sparse"), std::string::npos);
  }
}

TEST(Geometry, interleaved_views_are_read_with_their_stride) {
  Document document;
  // position, then normal, three times
  const int view =
      document.view(bytes_of(std::vector<float>{0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1}));
  document.json["bufferViews"][size_t(view)]["byteStride"] = 24;
  const Json accessor = {{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
  Json normal = accessor;
  normal["byteOffset"] = 12;
  const int positions = document.add("accessors", accessor), normals = document.add("accessors", normal);
  document.drawn({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.vertices.size(), 3u);
  expect_near(scene.vertices[2].position, {0, 1, 0});
  expect_near(scene.vertices[2].normal, {0, 0, 1});
}

TEST(Geometry, normalised_integers_become_fractions) {
  Document document;
  Json& primitive = document.triangle();
  const Json normalized = {{"normalized", true}};
  const int uv = document.accessor<uint16_t>({0, 0, 65535, 0, 0, 32768}, "VEC2", 5123, normalized);
  primitive["attributes"]["TEXCOORD_0"] = uv;
  const int second = document.accessor<uint8_t>({255, 0, 0, 51, 0, 0}, "VEC2", 5121, normalized);
  primitive["attributes"]["TEXCOORD_1"] = second;
  const int colour =
      document.accessor<uint8_t>({255, 0, 0, 51, 0, 255, 0, 255, 0, 0, 255, 255}, "VEC4", 5121, normalized);
  primitive["attributes"]["COLOR_0"] = colour;
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.vertices.size(), 3u);
  EXPECT_FLOAT_EQ(scene.vertices[1].uv0.x, 1);
  EXPECT_NEAR(scene.vertices[2].uv0.y, 0.5, 1e-4);
  EXPECT_FLOAT_EQ(scene.vertices[1].uv1.y, 0.2f);
  EXPECT_FLOAT_EQ(scene.vertices[0].colour.w, 0.2f);
}

TEST(Geometry, colours_of_three_components_are_opaque) {
  Document document;
  document.triangle()["attributes"]["COLOR_0"] = document.floats({1, 0, 0, 0, .5f, 0, 0, 0, 1}, "VEC3");
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.vertices.size(), 3u);
  EXPECT_EQ(scene.vertices[1].colour, glm::vec4(0, .5f, 0, 1));
}

TEST(Geometry, without_normals_triangles_are_flat_and_share_nothing) {
  Document document;
  const int positions = document.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3");
  document.drawn(
      {{"attributes", {{"POSITION", positions}}}, {"indices", document.shorts({0, 1, 2, 0, 3, 1})}});
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.vertices.size(), 6u);
  EXPECT_EQ(scene.indices, (std::vector<uint32_t>{0, 1, 2, 3, 4, 5}));
  for (int i = 0; i < 3; ++i) expect_near(scene.vertices[size_t(i)].normal, {0, 0, 1});
  for (int i = 3; i < 6; ++i) expect_near(scene.vertices[size_t(i)].normal, {0, 1, 0});
}

TEST(Geometry, zero_normals_and_tangents_are_replaced_by_unit_ones) {
  Document document;
  Json& primitive = document.triangle();
  primitive["attributes"]["NORMAL"] = document.floats({0, 0, 0, 0, 0, 9, 1e-30f, 0, 0}, "VEC3");
  primitive["attributes"]["TANGENT"] = document.floats({0, 0, 0, 1, 0, 3, 0, -1, 0, 0, 0, 0}, "VEC4");
  const Scene scene = scene_of(document);
  ASSERT_EQ(scene.vertices.size(), 3u);
  for (const Vertex& vertex : scene.vertices) {
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-6);
    EXPECT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 1e-6);
    EXPECT_EQ(std::abs(vertex.tangent.w), 1);
  }
  expect_near(glm::vec3(scene.vertices[1].tangent), {0, 1, 0});
  EXPECT_EQ(scene.vertices[1].tangent.w, -1);
  expect_near(scene.vertices[2].normal, {1, 0, 0});
}

TEST(Geometry, primitives_over_the_same_vertices_share_them) {
  Document document;
  const Json attributes = {{"POSITION", document.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, "VEC3")},
                           {"NORMAL", document.floats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3")}};
  document.drawn({{"attributes", attributes}, {"indices", document.shorts({0, 1, 2})}});
  document.drawn({{"attributes", attributes}, {"indices", document.shorts({2, 1, 3})}});
  const Scene scene = scene_of(document);
  EXPECT_EQ(scene.vertices.size(), 4u);
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.meshes[1].primitives[0].first_index, 3u);
  EXPECT_EQ(scene.meshes[1].primitives[0].first_vertex, 0u);
}

TEST(Geometry, quantized_positions_need_their_extension) {
  Document document;
  const int positions = document.accessor<int16_t>({0, 0, 0, 2, 0, 0, 0, 2, 0}, "VEC3", 5122);
  document.drawn({{"attributes", {{"POSITION", positions}}}});
  EXPECT_EQ(refusal_of(document).pointer, "/meshes/0/primitives/0/attributes/POSITION");
  document.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  document.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  expect_near(scene_of(document).vertices.at(1).position, {2, 0, 0});
}

TEST(Geometry, skins_and_morphs_are_said_once_and_the_rest_is_drawn) {
  Document document;
  Json& primitive = document.triangle();
  primitive["attributes"]["JOINTS_0"] = document.accessor<uint8_t>(std::vector<uint8_t>(12, 0), "VEC4", 5121);
  primitive["targets"] = Json::array({{{"POSITION", primitive["attributes"]["POSITION"]}}});
  document.add("meshes", document.json["meshes"][0]);
  const Scene scene = scene_of(document);
  EXPECT_EQ(scene.warnings.size(), 2u);
  EXPECT_TRUE(warns_of(scene, "skins"));
  EXPECT_TRUE(warns_of(scene, "morph targets"));
  EXPECT_EQ(scene.indices.size(), 6u);
}

} // namespace
} // namespace unghost::test
