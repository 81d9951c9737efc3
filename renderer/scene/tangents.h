// Normals and tangents for meshes that come without.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/scene/scene.h"

namespace unghost {

/// Some unit vector at a right angle to the unit vector `normal`.
glm::vec3 perpendicular_to(glm::vec3 normal);

/// `v` with length 1, or `otherwise` where it has no direction.
glm::vec3 normalized_or(glm::vec3 v, glm::vec3 otherwise);

/// Gives each triangle vertices of its own and its face's normal; `indices` become 0, 1, 2, ... A triangle
/// without an area gets (0, 1, 0).
void make_flat_normals(std::vector<Vertex>& vertices, std::vector<uint32_t>& indices);

/// Tangents from positions, normals and the texture coordinates of the normal map: summed over triangles,
/// made orthogonal to the normal (Lengyel 2001). Vertices shared by triangles whose coordinates wind
/// differently are split, so that a mirrored half keeps its sign. Where coordinates span no area any
/// perpendicular is taken.
void make_tangents(std::vector<Vertex>& vertices, std::vector<uint32_t>& indices,
                   const TextureUse& normal_map);

} // namespace unghost
