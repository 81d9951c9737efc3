#include "renderer/scene/gltf_attributes.h"

#include <algorithm>

#include "renderer/scene/tangents.h"

namespace unghost::gltf {

namespace {

/// The numbers of one attribute.
struct Stream {
  std::vector<float> numbers;
  int components = 0;

  float at(size_t element, int component) const {
    return numbers[element * size_t(components) + size_t(component)];
  }
  glm::vec3 vec3(size_t i) const { return {at(i, 0), at(i, 1), at(i, 2)}; }
};

struct Format {
  int least_components, most_components;
  bool may_be_unsigned; // normalised unsigned integers, without any extension
};

class Reader {
public:
  Reader(const Attributes& attributes, const Accessors& accessors, bool quantized, const std::string& pointer)
      : attributes_(attributes), accessors_(accessors), quantized_(quantized), pointer_(pointer) {}

  bool has(const char* name) const { return attributes_.contains(name); }
  Stream stream(const char* name, const Format& format, size_t count) const;

private:
  bool is_allowed(const Accessor& accessor, const Format& format) const;

  const Attributes& attributes_;
  const Accessors& accessors_;
  bool quantized_;
  const std::string& pointer_;
};

bool Reader::is_allowed(const Accessor& accessor, const Format& format) const {
  if (accessor.components < format.least_components || accessor.components > format.most_components)
    return false;
  if (accessor.is_matrix || accessor.component == Component::u32) return false;
  if (accessor.component == Component::f32 || quantized_) return true;
  return format.may_be_unsigned && accessor.normalized &&
         (accessor.component == Component::u8 || accessor.component == Component::u16);
}

Stream Reader::stream(const char* name, const Format& format, size_t count) const {
  const std::string pointer = pointer_ + "/attributes/" + name;
  const auto index = size_t(attributes_.at(name));
  const Accessor& accessor = accessors_[index];
  if (!is_allowed(accessor, format))
    refuse("an accessor of this type cannot be " + std::string(name), pointer);
  if (accessor.count != count) {
    refuse("has " + std::to_string(accessor.count) + " elements and the positions " + std::to_string(count),
           pointer);
  }
  return {accessors_.read_floats(index), accessor.components};
}

void read_coordinates(std::vector<Vertex>& vertices, const Reader& reader, const char* name,
                      glm::vec2 Vertex::*uv) {
  if (!reader.has(name)) return;
  const Stream stream = reader.stream(name, {2, 2, true}, vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) vertices[i].*uv = {stream.at(i, 0), stream.at(i, 1)};
}

void read_colours(std::vector<Vertex>& vertices, const Reader& reader) {
  if (!reader.has("COLOR_0")) return;
  const Stream stream = reader.stream("COLOR_0", {3, 4, true}, vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    const float alpha = stream.components == 4 ? stream.at(i, 3) : 1;
    vertices[i].colour = glm::max(glm::vec4(stream.vec3(i), alpha), 0.0f);
  }
}

void read_normals(std::vector<Vertex>& vertices, const Reader& reader) {
  if (!reader.has("NORMAL")) return;
  const Stream stream = reader.stream("NORMAL", {3, 3, false}, vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) vertices[i].normal = normalized_or(stream.vec3(i), {0, 1, 0});
}

/// After the normals: what has no tangent gets some perpendicular.
void read_tangents(std::vector<Vertex>& vertices, const Reader& reader) {
  for (Vertex& vertex : vertices) vertex.tangent = glm::vec4(perpendicular_to(vertex.normal), 1);
  if (!reader.has("TANGENT")) return;
  const Stream stream = reader.stream("TANGENT", {4, 4, false}, vertices.size());
  for (size_t i = 0; i < vertices.size(); ++i) {
    glm::vec4& tangent = vertices[i].tangent;
    tangent = glm::vec4(normalized_or(stream.vec3(i), glm::vec3(tangent)), stream.at(i, 3) < 0 ? -1 : 1);
  }
}

} // namespace

std::vector<Vertex> read_vertices(const Attributes& attributes, const Accessors& accessors, bool quantized,
                                  const std::string& pointer) {
  const Reader reader(attributes, accessors, quantized, pointer);
  const size_t count = accessors[size_t(attributes.at("POSITION"))].count;
  const Stream positions = reader.stream("POSITION", {3, 3, false}, count);
  std::vector<Vertex> vertices(count);
  for (size_t i = 0; i < count; ++i) vertices[i].position = positions.vec3(i);
  read_normals(vertices, reader);
  read_tangents(vertices, reader);
  read_coordinates(vertices, reader, "TEXCOORD_0", &Vertex::uv0);
  read_coordinates(vertices, reader, "TEXCOORD_1", &Vertex::uv1);
  read_colours(vertices, reader);
  return vertices;
}

} // namespace unghost::gltf
