// Small glTF documents made by hand, and a folder to put them in.
#pragma once

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "renderer/scene/load.h"

namespace unghost::test {

using Json = nlohmann::json;
using Bytes = std::vector<uint8_t>;

/// A folder of its own for one test, gone with it.
class TempFolder {
public:
  TempFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "unghost-XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~TempFolder() { std::filesystem::remove_all(path_); }
  TempFolder(const TempFolder&) = delete;
  TempFolder& operator=(const TempFolder&) = delete;

  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

  template <class Text> std::filesystem::path write(const std::string& name, const Text& bytes) const {
    std::ofstream(path_ / name, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
    return path_ / name;
  }

private:
  std::filesystem::path path_;
};

inline std::string base64(const Bytes& bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits = uint32_t(bytes[i]) << 16;
    if (i + 1 < bytes.size()) bits |= uint32_t(bytes[i + 1]) << 8;
    if (i + 2 < bytes.size()) bits |= uint32_t(bytes[i + 2]);
    for (int d = 0; d < 4; ++d) out += digits[bits >> (18 - 6 * d) & 63];
  }
  const size_t over = bytes.size() % 3;
  if (over) out.replace(out.size() - (3 - over), 3 - over, 3 - over, '=');
  return out;
}

template <class T> Bytes bytes_of(const std::vector<T>& values) {
  Bytes bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}

/// JSON with one buffer that grows.
struct Document {
  Json json = {{"asset", {{"version", "2.0"}}}};
  Bytes buffer;

  static int add(Json& array, Json item) {
    array.push_back(std::move(item));
    return int(array.size()) - 1;
  }
  int add(const char* collection, Json item) { return add(json[collection], std::move(item)); }

  int view(const Bytes& bytes) {
    buffer.resize((buffer.size() + 3) / 4 * 4);
    const size_t offset = buffer.size();
    buffer.insert(buffer.end(), bytes.begin(), bytes.end());
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
  }

  template <class T>
  int accessor(const std::vector<T>& values, const char* type, int component, Json more = {}) {
    const size_t width = type[0] == 'S' ? 1 : size_t(type[3] - '0');
    Json item = {{"bufferView", view(bytes_of(values))},
                 {"componentType", component},
                 {"count", values.size() / width},
                 {"type", type}};
    item.update(more.is_null() ? Json::object() : more);
    return add("accessors", item);
  }
  int floats(const std::vector<float>& values, const char* type) { return accessor(values, type, 5126); }
  int shorts(const std::vector<uint16_t>& values) { return accessor(values, "SCALAR", 5123); }

  /// A mesh of one primitive, a node that draws it, and the scene.
  int drawn(Json primitive) {
    const int mesh = add("meshes", {{"primitives", {std::move(primitive)}}});
    return add("nodes", {{"mesh", mesh}});
  }
  /// The triangle (0,0,0), (1,0,0), (0,1,0), drawn; returns its primitive.
  Json& triangle() {
    drawn({{"attributes", {{"POSITION", floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")}}}});
    return json["meshes"].back()["primitives"][0];
  }

  std::string text() const {
    Json out = json;
    if (!buffer.empty()) {
      out["buffers"] = {
          {{"byteLength", buffer.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer)}}};
    }
    return out.dump();
  }

  Bytes glb() const {
    Json out = json;
    out["buffers"] = {{{"byteLength", buffer.size()}}};
    std::string chunk = out.dump();
    chunk.resize((chunk.size() + 3) / 4 * 4, ' ');
    Bytes binary = buffer;
    binary.resize((binary.size() + 3) / 4 * 4);
    Bytes bytes;
    const auto word = [&](size_t value) {
      for (int i = 0; i < 4; ++i) bytes.push_back(uint8_t(value >> (8 * i)));
    };
    word(0x46546C67), word(2), word(12 + 8 + chunk.size() + 8 + binary.size());
    word(chunk.size()), word(0x4E4F534A);
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    word(binary.size()), word(0x004E4942);
    bytes.insert(bytes.end(), binary.begin(), binary.end());
    return bytes;
  }
};

using Loaded = std::variant<Scene, Refusal>;

inline Loaded load_text(const std::string& text) {
  const TempFolder folder;
  return load_scene(folder.write("scene.gltf", text));
}
inline Loaded load(const Document& document) { return load_text(document.text()); }

/// The scene, or a failed test with the sentence.
inline Scene scene_of(Loaded loaded) {
  if (auto* refusal = std::get_if<Refusal>(&loaded)) {
    ADD_FAILURE() << "refused: " << refusal->sentence();
    return {};
  }
  return std::get<Scene>(std::move(loaded));
}
inline Scene scene_of(const Document& document) { return scene_of(load(document)); }

/// The refusal, or a failed test.
inline Refusal refusal_of(Loaded loaded) {
  if (std::holds_alternative<Scene>(loaded)) {
    ADD_FAILURE() << "loaded, and should not have been";
    return {};
  }
  return std::get<Refusal>(std::move(loaded));
}
inline Refusal refusal_of(const Document& document) { return refusal_of(load(document)); }

inline bool warns_of(const Scene& scene, const std::string& word) {
  for (const std::string& warning : scene.warnings) {
    if (warning.find(word) != std::string::npos) return true;
  }
  return false;
}

inline void expect_near(glm::vec3 a, glm::vec3 b, float tolerance = 1e-5f) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

} // namespace unghost::test
