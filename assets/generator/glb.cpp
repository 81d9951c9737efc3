#include "assets/generator/glb.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace unghost::author {

using nlohmann::json;

namespace {

constexpr int array_buffer = 34962, element_array_buffer = 34963;
constexpr int unsigned_byte = 5121, unsigned_short = 5123, unsigned_int = 5125, real = 5126;

// A grid fine enough to be invisible (15 micrometres) and coarse enough that the last bits of sin() and
// pow(), which differ between math libraries, do not reach the file.
float settled(double value) {
  const double grid = 65536;
  return float(std::floor(value * grid + 0.5) / grid) + 0.0f;
}

template <typename T> void put(std::vector<uint8_t>& to, T value) {
  static_assert(std::endian::native == std::endian::little);
  const auto* bytes = reinterpret_cast<const uint8_t*>(&value);
  to.insert(to.end(), bytes, bytes + sizeof value);
}

template <typename V> std::vector<float> flat(const std::vector<V>& values) {
  std::vector<float> out;
  for (const V& value : values)
    for (int i = 0; i < V::length(); ++i) out.push_back(settled(value[i]));
  return out;
}

void pad(std::vector<uint8_t>& bytes, uint8_t with) {
  while (bytes.size() % 4 != 0) bytes.push_back(with);
}

template <typename V> json numbers(const V& v) {
  json out = json::array();
  for (int i = 0; i < V::length(); ++i) out.push_back(settled(v[i]));
  return out;
}

} // namespace

Glb::Glb() {
  json_["asset"] = {{"version", "2.0"}, {"generator", "unghost author-assets"}};
  json_["scene"] = 0;
  json_["samplers"] = {{{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}}};
}

int Glb::add_view(const std::vector<uint8_t>& bytes, int target) {
  pad(binary_, 0);
  json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes.size()}};
  if (target != 0) view["target"] = target;
  binary_.insert(binary_.end(), bytes.begin(), bytes.end());
  json_["bufferViews"].push_back(view);
  return int(json_["bufferViews"].size()) - 1;
}

int Glb::add_floats(const std::vector<float>& values, int components, bool with_bounds) {
  static const char* const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  std::vector<uint8_t> bytes;
  for (const float value : values) put(bytes, value);
  json accessor = {{"bufferView", add_view(bytes, array_buffer)},
                   {"componentType", real},
                   {"count", values.size() / size_t(components)},
                   {"type", types[components]}};
  if (with_bounds) {
    std::vector<float> low(values.begin(), values.begin() + components), high = low;
    for (size_t i = 0; i < values.size(); ++i) {
      float &l = low[i % size_t(components)], &h = high[i % size_t(components)];
      l = std::min(l, values[i]);
      h = std::max(h, values[i]);
    }
    accessor["min"] = low;
    accessor["max"] = high;
  }
  json_["accessors"].push_back(accessor);
  return int(json_["accessors"].size()) - 1;
}

int Glb::add_colours(const std::vector<glm::dvec4>& colours) {
  std::vector<uint8_t> bytes;
  for (const glm::dvec4& colour : colours)
    for (int i = 0; i < 4; ++i) bytes.push_back(uint8_t(std::clamp(colour[i], 0.0, 1.0) * 255 + 0.5));
  json_["accessors"].push_back({{"bufferView", add_view(bytes, array_buffer)},
                                {"componentType", unsigned_byte},
                                {"normalized", true},
                                {"count", colours.size()},
                                {"type", "VEC4"}});
  return int(json_["accessors"].size()) - 1;
}

int Glb::add_indices(const std::vector<uint32_t>& indices) {
  const bool wide = *std::max_element(indices.begin(), indices.end()) >= 65535;
  std::vector<uint8_t> bytes;
  for (const uint32_t index : indices) wide ? put(bytes, index) : put(bytes, uint16_t(index));
  json_["accessors"].push_back({{"bufferView", add_view(bytes, element_array_buffer)},
                                {"componentType", wide ? unsigned_int : unsigned_short},
                                {"count", indices.size()},
                                {"type", "SCALAR"}});
  return int(json_["accessors"].size()) - 1;
}

int Glb::add_texture(const std::string& name, const std::vector<uint8_t>& png) {
  json_["images"].push_back({{"name", name}, {"mimeType", "image/png"}, {"bufferView", add_view(png, 0)}});
  json_["textures"].push_back({{"name", name}, {"sampler", 0}, {"source", json_["images"].size() - 1}});
  return int(json_["textures"].size()) - 1;
}

int Glb::add_material(json material) {
  if (material.contains("extensions"))
    for (const auto& [name, value] : material["extensions"].items()) {
      json& used = json_["extensionsUsed"];
      if (std::find(used.begin(), used.end(), json(name)) == used.end()) used.push_back(name);
    }
  json_["materials"].push_back(std::move(material));
  return int(json_["materials"].size()) - 1;
}

int Glb::add_camera(json camera) {
  json_["cameras"].push_back(std::move(camera));
  return int(json_["cameras"].size()) - 1;
}

json Glb::primitive(const Part& part) {
  const Triangles& from = part.triangles;
  json attributes = {{"POSITION", add_floats(flat(from.positions), 3, true)},
                     {"NORMAL", add_floats(flat(from.normals), 3, false)}};
  assert(from.uvs.empty() || from.uvs.size() == from.positions.size());
  assert(from.colours.empty() || from.colours.size() == from.positions.size());
  if (!from.uvs.empty()) attributes["TEXCOORD_0"] = add_floats(flat(from.uvs), 2, false);
  if (!from.colours.empty()) attributes["COLOR_0"] = add_colours(from.colours);
  return {{"attributes", attributes}, {"indices", add_indices(from.indices)}, {"material", part.material}};
}

int Glb::add_mesh(const std::string& name, const std::vector<Part>& parts) {
  json primitives = json::array();
  for (const Part& part : parts)
    if (!part.triangles.indices.empty()) primitives.push_back(primitive(part));
  json_["meshes"].push_back({{"name", name}, {"primitives", primitives}});
  return int(json_["meshes"].size()) - 1;
}

int Glb::add_node(const std::string& name, int parent, const Placement& placement, json more) {
  json node = more.is_null() ? json::object() : std::move(more);
  node["name"] = name;
  if (placement.translation != glm::dvec3(0)) node["translation"] = numbers(placement.translation);
  if (placement.scale != glm::dvec3(1)) node["scale"] = numbers(placement.scale);
  const glm::dquat q = placement.rotation;
  if (q != glm::dquat(1, 0, 0, 0)) node["rotation"] = numbers(glm::dvec4(q.x, q.y, q.z, q.w));
  json_["nodes"].push_back(node);
  const int index = int(json_["nodes"].size()) - 1;
  if (parent >= 0)
    json_["nodes"][size_t(parent)]["children"].push_back(index);
  else
    json_["scenes"][0]["nodes"].push_back(index);
  return index;
}

std::vector<uint8_t> Glb::finish(const std::string& scene_name, json scene_extras) {
  json_["scenes"][0]["name"] = scene_name;
  json_["scenes"][0]["extras"] = std::move(scene_extras);
  pad(binary_, 0);
  json_["buffers"] = {{{"byteLength", binary_.size()}}};
  const std::string text = json_.dump();
  std::vector<uint8_t> words(text.begin(), text.end());
  pad(words, ' ');
  std::vector<uint8_t> file;
  put(file, uint32_t(0x46546C67)); // "glTF"
  put(file, uint32_t(2));
  put(file, uint32_t(12 + 8 + words.size() + 8 + binary_.size()));
  put(file, uint32_t(words.size()));
  put(file, uint32_t(0x4E4F534A)); // "JSON"
  file.insert(file.end(), words.begin(), words.end());
  put(file, uint32_t(binary_.size()));
  put(file, uint32_t(0x004E4942)); // "BIN"
  file.insert(file.end(), binary_.begin(), binary_.end());
  return file;
}

} // namespace unghost::author
