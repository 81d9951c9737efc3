// The smallest model there is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace unghost {

// Three points: (0,0,0), (1,0,0), (0,1,1).
inline constexpr const char* triangle =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAIA/";

/// A triangle over the box from 0 to 1, scaled and moved.
inline nlohmann::json model(std::vector<float> scale, std::vector<float> translation) {
  return {{"asset", {{"version", "2.0"}}},
          {"scene", 0},
          {"scenes", {{{"nodes", {0}}}}},
          {"nodes", {{{"name", "body"}, {"mesh", 0}, {"scale", scale}, {"translation", translation}}}},
          {"meshes", {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}}},
          {"buffers", {{{"uri", triangle}, {"byteLength", 36}}}},
          {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
          {"accessors",
           {{{"bufferView", 0},
             {"componentType", 5126},
             {"count", 3},
             {"type", "VEC3"},
             {"min", {0, 0, 0}},
             {"max", {1, 1, 1}}}}}};
}

/// As a .glb holds it, without a chunk of bytes.
inline std::string glb(const nlohmann::json& document) {
  std::string json = document.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto length = uint32_t(json.size());
  const uint32_t head[] = {0x46546c67, 2, 20 + length, length, 0x4e4f534a};
  return std::string(reinterpret_cast<const char*>(head), sizeof(head)) + json;
}

} // namespace unghost
