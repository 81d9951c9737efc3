#include "renderer/scene/tangents.h"

#include <cmath>

namespace unghost {

namespace {

struct Frame {
  glm::dvec3 tangent{0}, bitangent{0};
};

glm::dvec2 uv_of(const Vertex& vertex, const TextureUse& use) {
  const glm::dvec3 uv(use.uv_set == 1 ? vertex.uv1 : vertex.uv0, 1);
  return glm::dmat3x2(use.transform) * uv;
}

/// Twice the area that a triangle covers in the texture; its sign says which way round.
double area_in_texture(std::span<const Vertex> vertices, const uint32_t* corner, const TextureUse& use) {
  const glm::dvec2 a = uv_of(vertices[corner[0]], use);
  const glm::dvec2 b = uv_of(vertices[corner[1]], use) - a, c = uv_of(vertices[corner[2]], use) - a;
  return b.x * c.y - c.x * b.y;
}

/// Gives triangles that wind the other way in the texture copies of the vertices they share with the rest.
void split_mirrored(std::vector<Vertex>& vertices, std::vector<uint32_t>& indices, const TextureUse& use) {
  enum : uint8_t { unused, positive, negative };
  std::vector<uint8_t> winding(vertices.size(), unused);
  std::vector<uint32_t> copy_of(vertices.size(), 0); // 0: none yet, no copy has that index
  for (size_t i = 0; i + 2 < indices.size(); i += 3) {
    const double area = area_in_texture(vertices, &indices[i], use);
    if (area == 0 || !std::isfinite(area)) continue;
    const uint8_t wanted = area > 0 ? positive : negative;
    for (size_t corner = i; corner < i + 3; ++corner) {
      const uint32_t at = indices[corner];
      if (winding[at] == unused) winding[at] = wanted;
      if (winding[at] == wanted) continue;
      if (copy_of[at] == 0) {
        copy_of[at] = uint32_t(vertices.size());
        vertices.push_back(Vertex(vertices[at]));
        winding.push_back(wanted), copy_of.push_back(0);
      }
      indices[corner] = copy_of[at];
    }
  }
}

void add_triangle(std::vector<Frame>& frames, std::span<const Vertex> vertices, const uint32_t* corner,
                  const TextureUse& use) {
  const Vertex &a = vertices[corner[0]], &b = vertices[corner[1]], &c = vertices[corner[2]];
  const double area = area_in_texture(vertices, corner, use);
  if (area == 0 || !std::isfinite(area)) return;
  const glm::dvec3 ab = glm::dvec3(b.position) - glm::dvec3(a.position);
  const glm::dvec3 ac = glm::dvec3(c.position) - glm::dvec3(a.position);
  const glm::dvec2 uv_ab = uv_of(b, use) - uv_of(a, use), uv_ac = uv_of(c, use) - uv_of(a, use);
  // Not divided by the area but multiplied by its sign: larger triangles count more.
  const double sign = area > 0 ? 1 : -1;
  for (int i = 0; i < 3; ++i) {
    frames[corner[i]].tangent += sign * (ab * uv_ac.y - ac * uv_ab.y);
    frames[corner[i]].bitangent += sign * (ac * uv_ab.x - ab * uv_ac.x);
  }
}

} // namespace

glm::vec3 perpendicular_to(glm::vec3 normal) {
  const glm::vec3 aside = std::abs(normal.x) < 0.7f ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
  return glm::normalize(aside - normal * glm::dot(normal, aside));
}

glm::vec3 normalized_or(glm::vec3 v, glm::vec3 otherwise) {
  const glm::dvec3 exact(v); // squares of large and small floats leave the range of float
  const double length = glm::length(exact);
  return length > 0 && std::isfinite(length) ? glm::vec3(exact / length) : otherwise;
}

void make_flat_normals(std::vector<Vertex>& vertices, std::vector<uint32_t>& indices) {
  std::vector<Vertex> flat;
  flat.reserve(indices.size());
  for (const uint32_t index : indices) flat.push_back(vertices[index]);
  for (size_t i = 0; i + 2 < flat.size(); i += 3) {
    const glm::dvec3 a(flat[i].position), b(flat[i + 1].position), c(flat[i + 2].position);
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double length = glm::length(cross);
    const glm::vec3 normal =
        length > 0 && std::isfinite(length) ? glm::vec3(cross / length) : glm::vec3(0, 1, 0);
    for (size_t corner = i; corner < i + 3; ++corner) flat[corner].normal = normal;
  }
  for (size_t i = 0; i < indices.size(); ++i) indices[i] = uint32_t(i);
  vertices = std::move(flat);
}

void make_tangents(std::vector<Vertex>& vertices, std::vector<uint32_t>& indices,
                   const TextureUse& normal_map) {
  split_mirrored(vertices, indices, normal_map);
  std::vector<Frame> frames(vertices.size());
  for (size_t i = 0; i + 2 < indices.size(); i += 3) add_triangle(frames, vertices, &indices[i], normal_map);
  for (size_t i = 0; i < vertices.size(); ++i) {
    const glm::dvec3 normal(vertices[i].normal), sum = frames[i].tangent;
    const glm::dvec3 tangent = sum - normal * glm::dot(normal, sum);
    const double length = glm::length(tangent);
    const bool has_direction = std::isfinite(length) && length > 1e-12 * glm::length(sum) && length > 0;
    const glm::vec3 unit = has_direction ? glm::vec3(tangent / length) : perpendicular_to(vertices[i].normal);
    const bool mirrored = glm::dot(glm::cross(normal, glm::dvec3(unit)), frames[i].bitangent) < 0;
    vertices[i].tangent = glm::vec4(unit, mirrored ? -1 : 1);
  }
}

} // namespace unghost
