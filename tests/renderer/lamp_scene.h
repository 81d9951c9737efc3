// Scenes of a flat plate, boxes and lamps, of which some slide back and forth.
#pragma once

#include <random>

#include "tests/flat_picture.h"
#include "tests/renderer/box_scene.h"

namespace unghost {

/// Takes a node from `from` to `to` within a second, and back within the next.
inline void slide(Scene& scene, size_t node, glm::vec3 from, glm::vec3 to) {
  if (scene.animations.empty()) scene.animations.push_back({.name = "slides", .duration = 2});
  scene.animations[0].tracks.push_back(
      {.node = int(node),
       .times = {0, 1, 2},
       .values = {glm::vec4(from, 0), glm::vec4(to, 0), glm::vec4(from, 0)}});
  scene.nodes[node].local.translation = from;
}

/// 12 m by 12 m, its upper side in the plane y = 0: node 0.
inline Scene plate_of(Material material) {
  material.metalness = 0, material.roughness = 1;
  Scene scene = box_of(material);
  scene.vehicle = -1;
  scene.nodes[0].local = {.translation = {0, -0.2f, 0}, .scale = {6, 0.1f, 6}};
  return scene;
}

/// Paints a plate with grey noise in squares of 5 cm, of which colours around a pixel say little: it takes
/// the place of both textures of the first material.
inline void add_noise(Scene& scene) {
  constexpr uint32_t side = 64;
  Image noise = picture_of(side, side, {0, 0, 0});
  std::mt19937 random(7);
  for (uint32_t i = 0; i < side * side; ++i)
    for (uint32_t grey = random() % 256, channel = 0; channel < 3; ++channel)
      noise.rgba[4 * i + channel] = uint8_t(grey);
  scene.images.push_back(std::move(noise));
  const float times = 12 / (0.05f * side); // over the plate
  for (Vertex& vertex : scene.vertices)
    vertex.uv0 = glm::vec2(vertex.position.x, vertex.position.z) * (times / 2);
  Material& material = scene.materials[0];
  material.base_colour_texture.image = material.emissive_texture.image = 0;
}

/// Returns its node.
inline size_t add_lamp(Scene& scene, float intensity, glm::vec3 at) {
  scene.lights.push_back({.kind = LightKind::point, .intensity = glm::vec3(intensity)});
  scene.nodes.push_back({.name = "lamp", .light = int(scene.lights.size()) - 1});
  scene.nodes.back().local.translation = at;
  return scene.nodes.size() - 1;
}

/// Another box of the scene's first mesh. Returns its node.
inline size_t add_box(Scene& scene, float half_side, glm::vec3 at) {
  scene.nodes.push_back({.name = "box", .mesh = 0});
  scene.nodes.back().local = {.translation = at, .scale = glm::vec3(half_side)};
  return scene.nodes.size() - 1;
}

} // namespace unghost
