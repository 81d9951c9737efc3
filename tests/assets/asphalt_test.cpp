// The committed scene is the one that the generator writes, and it is what the program takes it for.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <png.h>

#include "assets/generator/author.h"
#include "assets/generator/textures.h"

namespace {

using glm::vec3;
using nlohmann::json;

uint32_t word(const std::vector<uint8_t>& bytes, size_t at) {
  uint32_t value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// Just enough glTF to read back what the generator writes: one buffer, tightly packed accessors.
struct File {
  std::vector<uint8_t> bytes;
  json gltf;
  size_t binary; // where the buffer starts

  explicit File(std::vector<uint8_t> whole) : bytes(std::move(whole)) {
    const size_t text = word(bytes, 12);
    gltf = json::parse(bytes.begin() + 20, bytes.begin() + 20 + std::ptrdiff_t(text));
    binary = 20 + text + 8;
  }

  size_t start(const json& accessor) const {
    return binary + gltf["bufferViews"][accessor["bufferView"].get<size_t>()]["byteOffset"].get<size_t>();
  }

  std::vector<vec3> vectors(const json& index) const {
    const json& accessor = gltf["accessors"][index.get<size_t>()];
    std::vector<vec3> out(accessor["count"].get<size_t>());
    std::memcpy(out.data(), bytes.data() + start(accessor), out.size() * sizeof(vec3));
    return out;
  }

  std::vector<uint32_t> indices(const json& primitive) const {
    const json& accessor = gltf["accessors"][primitive["indices"].get<size_t>()];
    const size_t size = accessor["componentType"] == 5125 ? 4 : 2;
    std::vector<uint32_t> out(accessor["count"].get<size_t>(), 0);
    for (size_t i = 0; i < out.size(); ++i)
      std::memcpy(&out[i], bytes.data() + start(accessor) + i * size, size);
    return out;
  }

  const json& node(const std::string& name) const {
    for (const json& n : gltf["nodes"])
      if (n["name"] == name) return n;
    throw std::runtime_error("no node " + name);
  }

  size_t triangles(const json& node) const {
    size_t count = 0;
    if (node.contains("mesh"))
      for (const json& primitive : gltf["meshes"][node["mesh"].get<size_t>()]["primitives"])
        count += indices(primitive).size() / 3;
    for (const json& child : node.value("children", json::array()))
      count += triangles(gltf["nodes"][child.get<size_t>()]);
    return count;
  }
};

const File& authored() {
  static const File file(unghost::author::author_asphalt());
  return file;
}

vec3 translation(const json& node) {
  return {node["translation"][0], node["translation"][1], node["translation"][2]};
}

template <typename Visit> void each_primitive(const File& file, Visit visit) {
  for (const json& mesh : file.gltf["meshes"])
    for (const json& primitive : mesh["primitives"]) visit(mesh["name"].get<std::string>(), primitive);
}

TEST(asphalt, is_what_the_generator_writes) {
  std::ifstream in(UNGHOST_ASSETS "/asphalt.glb", std::ios::binary);
  const std::vector<uint8_t> committed{std::istreambuf_iterator<char>(in), {}};
  ASSERT_EQ(committed.size(), authored().bytes.size()) << "run author-assets";
  EXPECT_TRUE(committed == authored().bytes) << "run author-assets";
}

TEST(asphalt, keeps_to_its_budget) {
  EXPECT_LE(authored().bytes.size(), 3'500'000u);
  EXPECT_LE(authored().triangles(authored().node("car")), 25'000u);
}

TEST(asphalt, the_car_is_a_tagged_vehicle_with_wheels_on_the_ground) {
  EXPECT_EQ(authored().node("car")["extras"], json::parse(R"({"vehicle": true, "tag": 1})"));
  for (const std::string side : {"left", "right"}) {
    for (const std::string axle : {"front", "rear"}) {
      const json& pivot = authored().node("wheel_" + axle + "_" + side);
      EXPECT_EQ(pivot["extras"]["wheel"]["steers"], axle == "front");
      EXPECT_NEAR(translation(pivot).y, pivot["extras"]["wheel"]["radius"].get<float>(), 2e-5);
      EXPECT_EQ(translation(pivot).x > 0, side == "left");
      EXPECT_EQ(translation(pivot).z > 0, axle == "front");
      EXPECT_FALSE(pivot.contains("rotation"));
    }
  }
}

TEST(asphalt, a_wheel_reaches_its_radius_all_round_its_pivot) {
  const json& pivot = authored().node("wheel_front_left");
  const float radius = pivot["extras"]["wheel"]["radius"];
  const json& mesh =
      authored().gltf["meshes"][authored().node("wheel_mesh_front_left")["mesh"].get<size_t>()];
  vec3 low(9), high(-9);
  for (const json& primitive : mesh["primitives"])
    for (const vec3 p : authored().vectors(primitive["attributes"]["POSITION"]))
      low = min(low, p), high = max(high, p);
  EXPECT_NEAR(low.y, -radius, 0.002);
  EXPECT_NEAR(high.y, radius, 0.002);
  EXPECT_NEAR(low.z, -radius, 0.002);
  EXPECT_NEAR(high.z, radius, 0.002);
}

TEST(asphalt, the_car_has_the_size_of_one_and_clears_the_ground) {
  const json& mesh = authored().gltf["meshes"][authored().node("car_body")["mesh"].get<size_t>()];
  vec3 low(9), high(-9);
  for (const json& primitive : mesh["primitives"])
    for (const vec3 p : authored().vectors(primitive["attributes"]["POSITION"]))
      low = min(low, p), high = max(high, p);
  EXPECT_NEAR(high.z - low.z, 4.4, 0.25);
  EXPECT_NEAR(high.x - low.x, 2.05, 0.15); // over the mirrors
  EXPECT_NEAR(high.y, 1.28, 0.05);
  EXPECT_GT(low.y, 0.08);
}

TEST(asphalt, the_circle_passes_through_the_origin_heading_z) {
  EXPECT_EQ(authored().gltf["scenes"][0]["extras"]["track"]["radius"], 150);
  const json& road = authored().node("road_0");
  EXPECT_EQ(translation(road), vec3(150, 0, 0));
}

TEST(asphalt, normals_are_unit_and_indices_in_range) {
  each_primitive(authored(), [](const std::string& name, const json& primitive) {
    const auto normals = authored().vectors(primitive["attributes"]["NORMAL"]);
    for (const vec3 n : normals) ASSERT_NEAR(length(n), 1, 1e-4) << name;
    for (const uint32_t index : authored().indices(primitive)) ASSERT_LT(index, normals.size()) << name;
  });
}

TEST(asphalt, bounds_are_the_tightest) {
  each_primitive(authored(), [](const std::string& name, const json& primitive) {
    vec3 low(1e9), high(-1e9);
    for (const vec3 p : authored().vectors(primitive["attributes"]["POSITION"]))
      low = min(low, p), high = max(high, p);
    const json& accessor = authored().gltf["accessors"][primitive["attributes"]["POSITION"].get<size_t>()];
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(accessor["min"][size_t(i)].get<float>(), low[i]) << name;
      EXPECT_EQ(accessor["max"][size_t(i)].get<float>(), high[i]) << name;
    }
  });
}

// Leaf cards are shaded as a crown, not as cards: theirs are left out.
TEST(asphalt, triangles_face_where_their_normals_point) {
  each_primitive(authored(), [](const std::string& name, const json& primitive) {
    if (authored().gltf["materials"][primitive["material"].get<size_t>()].value("doubleSided", false)) return;
    const auto p = authored().vectors(primitive["attributes"]["POSITION"]);
    const auto n = authored().vectors(primitive["attributes"]["NORMAL"]);
    const auto index = authored().indices(primitive);
    for (size_t i = 0; i < index.size(); i += 3) {
      const uint32_t a = index[i], b = index[i + 1], c = index[i + 2];
      const vec3 face = cross(p[b] - p[a], p[c] - p[a]);
      // Slivers of a cut have no direction worth the name.
      if (length(face) < 1e-5f) continue;
      ASSERT_GT(dot(normalize(face), n[a] + n[b] + n[c]), 0) << name << " triangle " << i / 3;
    }
  });
}

// The linear luminance of the asphalt's picture, halved `halvings` times as mipmaps are.
std::vector<float> asphalt_luminance(int halvings, int& side) {
  const std::vector<uint8_t> file = unghost::author::asphalt_colour_png();
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&png, file.data(), file.size()));
  png.format = PNG_FORMAT_LINEAR_Y;
  side = int(png.width);
  std::vector<uint16_t> wide(PNG_IMAGE_SIZE(png) / 2);
  EXPECT_TRUE(png_image_finish_read(&png, nullptr, wide.data(), 0, nullptr));
  std::vector<float> level;
  for (const uint16_t value : wide) level.push_back(value / 65535.0f);
  for (; halvings > 0; --halvings, side /= 2) {
    std::vector<float> half;
    for (int y = 0; y < side; y += 2) {
      for (int x = 0; x < side; x += 2) {
        const size_t i = size_t(y * side + x), below = i + size_t(side);
        half.push_back((level[i] + level[i + 1] + level[below] + level[below + 1]) / 4);
      }
    }
    level = half;
  }
  return level;
}

// What makes the scene: a box of 3x3 pixels spans so much of the road's own range that it rejects next to
// nothing.
TEST(asphalt, contrast_between_neighbours_lasts_from_stones_to_hands) {
  for (int halvings = 0; halvings <= 4; ++halvings) { // 3 mm to 5 cm a texel
    int side = 0;
    const std::vector<float> level = asphalt_luminance(halvings, side);
    double mean = 0, range = 0;
    for (int y = 1; y + 1 < side; ++y) {
      for (int x = 1; x + 1 < side; ++x) {
        float low = 1, high = 0;
        for (int i = 0; i < 9; ++i) {
          const float value = level[size_t((y + i / 3 - 1) * side + x + i % 3 - 1)];
          low = std::min(low, value), high = std::max(high, value);
        }
        range += high - low;
        mean += level[size_t(y * side + x)];
      }
    }
    const double count = double(side - 2) * (side - 2);
    EXPECT_NEAR(mean / count, 0.16, 0.03);
    EXPECT_GT(range / count, 0.13) << halvings;
  }
}

TEST(asphalt, nothing_stands_between_the_cameras_and_the_car) {
  // A camera on the left of the path, from 5 m behind the origin to 25 m past it, sees the road.
  for (const json& node : authored().gltf["nodes"]) {
    const std::string name = node["name"];
    const std::set<std::string> upright = {"lamp", "tree", "marker", "speed", "gantry", "chevron", "tyre"};
    if (!node.contains("translation") || !upright.contains(name.substr(0, name.find('_')))) continue;
    const vec3 from_centre = translation(node) - vec3(150, 0, 0);
    const float along = 150 * std::atan2(from_centre.z, -from_centre.x);
    const float left = 150 - length(glm::vec2(from_centre.x, from_centre.z));
    const bool near_cameras = along > -20 && along < 60;
    EXPECT_FALSE(near_cameras && left > -3 && left < 9.5f) << name << " at " << along << ", " << left;
  }
}

} // namespace
