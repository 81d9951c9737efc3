// The smallest scene that a rig can move.
#pragma once

#include "renderer/scene/scene.h"

namespace unghost {

/// A box that a rig moves, of one material.
inline Scene box_of(const Material& material) {
  Scene scene;
  scene.materials.push_back(material);
  Bounds bounds;
  for (int face = 0; face < 6; ++face)
    for (int corner = 0; corner < 4; ++corner) {
      const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3, side = face % 2 * 2 - 1;
      glm::vec3 position(0), normal(0);
      normal[axis] = position[axis] = float(side);
      position[u] = corner == 1 || corner == 2 ? 1.0f : -1.0f;
      position[v] = float(side) * (corner >= 2 ? 1.0f : -1.0f); // front faces turn counter-clockwise
      scene.vertices.push_back({.position = position + glm::vec3(0, 1, 0), .normal = normal});
      bounds.add(glm::dvec3(scene.vertices.back().position));
    }
  for (uint32_t face = 0; face < 6; ++face)
    for (const uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) scene.indices.push_back(4 * face + corner);
  scene.meshes.push_back(
      {.name = "box",
       .primitives = {{.index_count = 36, .vertex_count = 24, .material = 0, .bounds = bounds}}});
  scene.nodes.push_back({.name = "box", .mesh = 0});
  scene.vehicle = 0;
  return scene;
}

} // namespace unghost
