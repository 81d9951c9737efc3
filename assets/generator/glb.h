// Writes glTF 2.0 as one binary file. What is added first comes first, so that equal input gives equal bytes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "assets/generator/triangles.h"

namespace unghost::author {

/// Triangles and the material they are drawn with.
struct Part {
  int material;
  Triangles triangles;
};

struct Placement {
  glm::dvec3 translation{0};
  glm::dquat rotation{1, 0, 0, 0};
  glm::dvec3 scale{1};
};

class Glb {
public:
  Glb();

  /// All of these return the index of what was added. `json` is glTF's own object.
  int add_texture(const std::string& name, const std::vector<uint8_t>& png);
  int add_material(nlohmann::json json);
  int add_camera(nlohmann::json json);
  /// Empty parts are left out. uvs and colours are written where the part has them.
  int add_mesh(const std::string& name, const std::vector<Part>& parts);
  /// `parent` -1: in the scene's root. `more` is merged into the node: {"mesh": 3, "extras": {...}}.
  int add_node(const std::string& name, int parent, const Placement& placement, nlohmann::json more = {});

  /// The file. `scene_extras` becomes the scene's extras.
  std::vector<uint8_t> finish(const std::string& scene_name, nlohmann::json scene_extras);

private:
  int add_view(const std::vector<uint8_t>& bytes, int target);
  int add_floats(const std::vector<float>& values, int components, bool with_bounds);
  int add_colours(const std::vector<glm::dvec4>& colours);
  int add_indices(const std::vector<uint32_t>& indices);
  nlohmann::json primitive(const Part& part);

  nlohmann::json json_;
  std::vector<uint8_t> binary_;
};

} // namespace unghost::author
