#include "renderer/scene/gltf_meshes.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "renderer/scene/gltf_attributes.h"
#include "renderer/scene/gltf_topology.h"
#include "renderer/scene/tangents.h"

namespace unghost::gltf {

namespace {

/// The vertices that `indices` name, which then count from their first: what several primitives share is
/// copied for each that needs tangents of its own.
std::vector<Vertex> picked(const std::vector<Vertex>& vertices, std::vector<uint32_t>& indices) {
  std::unordered_map<uint32_t, uint32_t> places;
  std::vector<Vertex> used;
  for (uint32_t& index : indices) {
    const auto [at, is_new] = places.try_emplace(index, uint32_t(used.size()));
    if (is_new) used.push_back(vertices[index]);
    index = at->second;
  }
  return used;
}

class Reader {
public:
  struct Sources {
    const tinygltf::Model& model;
    const Accessors& accessors;
    const LoadLimits& limits;
    Warnings& warnings;
  };

  Reader(Scene& scene, const Sources& from)
      : scene_(scene), from_(from),
        quantized_(std::ranges::find(from.model.extensionsUsed, "KHR_mesh_quantization") !=
                   from.model.extensionsUsed.end()) {}

  void mesh(size_t index);

private:
  struct Range {
    uint32_t first = 0, count = 0;
  };

  bool can_be_drawn(const tinygltf::Primitive& from);
  Primitive primitive(const tinygltf::Primitive& from, const std::string& pointer);
  std::vector<uint32_t> triangles(const tinygltf::Primitive& from, const std::string& pointer) const;
  Range vertices(const tinygltf::Primitive& from, int material, std::vector<uint32_t>& indices,
                 const std::string& pointer);
  Range store(const std::vector<Vertex>& vertices, size_t indices, const std::string& pointer);
  const std::vector<Vertex>& as_in_file(const tinygltf::Primitive& from, const std::string& pointer);
  void check_budget(uint64_t vertices, uint64_t indices, const std::string& pointer) const;

  Scene& scene_;
  Sources from_;
  bool quantized_;
  std::map<Attributes, Range> shared_; // primitives often are parts of the same vertices
  Attributes last_attributes_;
  std::vector<Vertex> last_vertices_;
};

bool Reader::can_be_drawn(const tinygltf::Primitive& from) {
  if (!from.targets.empty())
    from_.warnings.say("morph targets are not supported; meshes keep their base shape");
  if (from.attributes.contains("JOINTS_0"))
    from_.warnings.say("skins are not supported; meshes keep their bind pose");
  if (from.mode < int(Topology::triangles)) {
    from_.warnings.say("points and lines are not supported and left out");
    return false;
  }
  if (!from.attributes.contains("POSITION")) {
    from_.warnings.say("a primitive without positions is left out");
    return false;
  }
  const auto is_missing = [&](int accessor) { return !from_.accessors.has_data(size_t(accessor)); };
  if (is_missing(from.attributes.at("POSITION")) || (from.indices >= 0 && is_missing(from.indices))) {
    from_.warnings.say("a primitive whose data is not in the file is left out");
    return false;
  }
  return true;
}

void Reader::check_budget(uint64_t vertices, uint64_t indices, const std::string& pointer) const {
  const uint64_t bytes = (scene_.vertices.size() + vertices) * sizeof(Vertex) +
                         (scene_.indices.size() + indices) * sizeof(uint32_t);
  if (bytes > from_.limits.geometry_bytes) {
    refuse("all meshes together are larger than " + std::to_string(from_.limits.geometry_bytes) + " bytes",
           pointer);
  }
}

std::vector<uint32_t> Reader::triangles(const tinygltf::Primitive& from, const std::string& pointer) const {
  const uint64_t count = from_.accessors[size_t(from.attributes.at("POSITION"))].count;
  const uint64_t corners = from.indices >= 0 ? from_.accessors[size_t(from.indices)].count : count;
  check_budget(count, from.mode == int(Topology::triangles) ? corners : 3 * corners, pointer);
  std::vector<uint32_t> indices;
  if (from.indices >= 0) {
    indices = from_.accessors.read_indices(size_t(from.indices));
    const auto beyond = std::ranges::find_if(indices, [&](uint32_t index) { return index >= count; });
    if (beyond != indices.end()) {
      refuse("has the index " + std::to_string(*beyond) + ", and there are " + std::to_string(count) +
                 " vertices",
             pointer + "/indices");
    }
  } else {
    indices.resize(count);
    std::iota(indices.begin(), indices.end(), 0u);
  }
  return triangle_list(Topology(from.mode), indices);
}

Reader::Range Reader::store(const std::vector<Vertex>& vertices, size_t indices, const std::string& pointer) {
  check_budget(vertices.size(), indices, pointer);
  const Range range{uint32_t(scene_.vertices.size()), uint32_t(vertices.size())};
  scene_.vertices.insert(scene_.vertices.end(), vertices.begin(), vertices.end());
  return range;
}

const std::vector<Vertex>& Reader::as_in_file(const tinygltf::Primitive& from, const std::string& pointer) {
  if (from.attributes != last_attributes_) {
    last_vertices_ = read_vertices(from.attributes, from_.accessors, quantized_, pointer);
    last_attributes_ = from.attributes;
  }
  return last_vertices_;
}

Reader::Range Reader::vertices(const tinygltf::Primitive& from, int material, std::vector<uint32_t>& indices,
                               const std::string& pointer) {
  const bool has_normals = from.attributes.contains("NORMAL");
  const TextureUse& normal_map = scene_.materials[size_t(material)].normal_texture;
  // glTF 2.0, 3.7.2.1: tangents without normals are to be ignored.
  const bool needs_tangents = normal_map.image >= 0 && !(has_normals && from.attributes.contains("TANGENT"));
  if (has_normals && !needs_tangents) {
    if (const auto known = shared_.find(from.attributes); known != shared_.end()) return known->second;
    return shared_[from.attributes] = store(as_in_file(from, pointer), indices.size(), pointer);
  }
  std::vector<Vertex> vertices = picked(as_in_file(from, pointer), indices);
  if (!has_normals) {
    check_budget(indices.size(), indices.size(), pointer);
    make_flat_normals(vertices, indices);
    for (Vertex& vertex : vertices) vertex.tangent = glm::vec4(perpendicular_to(vertex.normal), 1);
  }
  if (needs_tangents) make_tangents(vertices, indices, normal_map);
  return store(vertices, indices.size(), pointer);
}

Primitive Reader::primitive(const tinygltf::Primitive& from, const std::string& pointer) {
  const int material = from.material >= 0 ? from.material : int(scene_.materials.size()) - 1;
  std::vector<uint32_t> indices = triangles(from, pointer);
  const Range range = vertices(from, material, indices, pointer);
  Primitive primitive{.first_index = uint32_t(scene_.indices.size()),
                      .index_count = uint32_t(indices.size()),
                      .first_vertex = range.first,
                      .vertex_count = range.count,
                      .material = material,
                      .bounds = {}};
  for (const uint32_t index : indices) primitive.bounds.add(scene_.vertices[range.first + index].position);
  scene_.indices.insert(scene_.indices.end(), indices.begin(), indices.end());
  return primitive;
}

void Reader::mesh(size_t index) {
  const tinygltf::Mesh& from = from_.model.meshes[index];
  Mesh mesh{.name = from.name, .primitives = {}};
  for (size_t i = 0; i < from.primitives.size(); ++i) {
    const std::string pointer = pointer_to("meshes", index, "primitives") + "/" + std::to_string(i);
    if (!can_be_drawn(from.primitives[i])) continue;
    const Primitive drawn = primitive(from.primitives[i], pointer);
    if (drawn.index_count > 0) mesh.primitives.push_back(drawn);
  }
  scene_.meshes.push_back(std::move(mesh));
}

} // namespace

void read_meshes(Scene& scene, const tinygltf::Model& model, const Accessors& accessors,
                 const LoadLimits& limits, Warnings& warnings) {
  Reader reader(scene, {model, accessors, limits, warnings});
  for (size_t i = 0; i < model.meshes.size(); ++i) reader.mesh(i);
}

} // namespace unghost::gltf
