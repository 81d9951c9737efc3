#include "renderer/scene/bounds.h"

#include "renderer/scene/animation.h"

namespace unghost {

namespace {

std::vector<Bounds> bounds_of_meshes(const Scene& scene) {
  std::vector<Bounds> boxes(scene.meshes.size());
  for (size_t i = 0; i < boxes.size(); ++i) {
    for (const Primitive& primitive : scene.meshes[i].primitives) {
      if (primitive.bounds.empty()) continue;
      boxes[i].add(primitive.bounds.low), boxes[i].add(primitive.bounds.high);
    }
  }
  return boxes;
}

Bounds bounds_of(const Scene& scene, const std::vector<bool>& counted) {
  const std::vector<Bounds> meshes = bounds_of_meshes(scene);
  const std::vector<glm::dmat4> world = world_matrices(scene, default_pose(scene));
  Bounds all;
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    if (!counted[i] || scene.nodes[i].mesh < 0) continue;
    const Bounds box = transformed(meshes[size_t(scene.nodes[i].mesh)], world[i]);
    if (!box.empty()) all.add(box.low), all.add(box.high);
  }
  return all;
}

} // namespace

std::array<glm::dvec4, 8> corners_of(const Bounds& box) {
  std::array<glm::dvec4, 8> corners;
  for (size_t i = 0; i < 8; ++i)
    corners[i] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                  i & 4 ? box.high.z : box.low.z, 1};
  return corners;
}

Bounds transformed(const Bounds& box, const glm::dmat4& matrix) {
  Bounds out;
  if (box.empty()) return out;
  for (const glm::dvec4& corner : corners_of(box)) out.add(glm::vec3(matrix * corner));
  return out;
}

Bounds scene_bounds(const Scene& scene) {
  return bounds_of(scene, std::vector<bool>(scene.nodes.size(), true));
}

Bounds node_bounds(const Scene& scene, int node) { return bounds_of(scene, subtree_of(scene, node)); }

Bounds vehicle_bounds(const Scene& scene) {
  if (scene.vehicle < 0) return {};
  const glm::dmat4 world = world_matrices(scene, default_pose(scene))[size_t(scene.vehicle)];
  return transformed(node_bounds(scene, scene.vehicle), glm::inverse(world));
}

std::vector<bool> subtree_of(const Scene& scene, int node) {
  std::vector<bool> below(scene.nodes.size(), false);
  for (size_t i = size_t(node); i < scene.nodes.size(); ++i) {
    const int parent = scene.nodes[i].parent;
    below[i] = i == size_t(node) || (parent >= 0 && below[size_t(parent)]);
  }
  return below;
}

} // namespace unghost
