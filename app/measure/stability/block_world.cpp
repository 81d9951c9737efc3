#include "app/measure/stability/block_world.h"

#include <array>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace unghost {
namespace {

constexpr uint8_t block_tag = 1;
constexpr int ground_sides = 40, chequers = 8; // of the block, along the ground; and until colours come again

/// A rectangle about `middle`, spanned by half of its sides; it faces along their cross product.
void add_rectangle(Scene& scene, glm::vec3 middle, glm::vec3 right, glm::vec3 up, Primitive& primitive,
                   glm::vec3 colour = glm::vec3(1)) {
  const auto first = uint32_t(scene.vertices.size()) - primitive.first_vertex;
  const glm::vec3 normal = glm::normalize(glm::cross(right, up));
  for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
    const glm::vec3 position = middle + corner.x * right + corner.y * up;
    scene.vertices.push_back({.position = position,
                              .normal = normal,
                              .tangent = glm::vec4(glm::normalize(right), 1),
                              .colour = glm::vec4(colour, 1)});
    primitive.bounds.add(position);
  }
  for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) scene.indices.push_back(first + i);
  primitive.vertex_count += 4, primitive.index_count += 6;
}

Primitive begun(const Scene& scene, int material) {
  return {.first_index = uint32_t(scene.indices.size()),
          .first_vertex = uint32_t(scene.vertices.size()),
          .material = material};
}

Material flat(glm::vec3 colour) {
  Material material;
  material.base_colour = glm::vec4(colour, 1), material.unlit = true;
  return material;
}

int add_node(Scene& scene, const Primitive& primitive, glm::vec3 at, uint8_t tag) {
  scene.meshes.push_back({.name = {}, .primitives = {primitive}});
  Node node;
  node.mesh = int(scene.meshes.size()) - 1, node.local.translation = at, node.tag = tag;
  scene.nodes.push_back(node);
  return int(scene.nodes.size()) - 1;
}

/// From 0.3 to 1, the same for the same square.
glm::vec3 colour_of_chequer(int x, int z) {
  const uint32_t hash =
      (uint32_t(x % chequers) * 73856093u ^ uint32_t(z % chequers) * 19349663u) * 2654435769u;
  return 0.3f + 0.7f * glm::vec3(hash >> 24, hash >> 16 & 255, hash >> 8 & 255) / 255.0f;
}

Primitive ground_of(Scene& scene, const BlockWorld& world) {
  Primitive ground = begun(scene, 0);
  const float half = world.side / 2, far = half * float(ground_sides);
  if (!world.chequered) add_rectangle(scene, {0, 0, 0}, {far, 0, 0}, {0, 0, -far}, ground);
  for (int x = 0; x < ground_sides && world.chequered; ++x)
    for (int z = 0; z < ground_sides; ++z) {
      const glm::vec3 middle(float(x) + 0.5f, 0, float(z) + 0.5f);
      add_rectangle(scene, world.side * middle - glm::vec3(far, 0, far), {half, 0, 0}, {0, 0, -half}, ground,
                    colour_of_chequer(x, z));
    }
  return ground;
}

} // namespace

Scene block_scene(const BlockWorld& world) {
  Scene scene;
  scene.materials = {flat({0.2f, 0.25f, 0.2f}), flat({0.8f, 0.2f, 0.1f})};
  const float half = world.side / 2;
  add_node(scene, ground_of(scene, world), world.origin, 0);
  Primitive block = begun(scene, 1);
  for (const int axis : {0, 1, 2})
    for (const float sign : {-1.0f, 1.0f}) {
      glm::vec3 out(0), right(0);
      out[axis] = sign * half, right[(axis + 1) % 3] = half;
      add_rectangle(scene, out + glm::vec3(0, half, 0), right, glm::cross(out / half, right), block);
    }
  scene.vehicle = add_node(scene, block, world.origin, block_tag);
  return scene;
}

Renderer block_renderer(Device& device, const std::filesystem::path& shaders) {
  return {device, shaders, block_scene({.chequered = true})};
}

Instant block_instant(const BlockWorld& world, glm::dvec3 moved) {
  const glm::dvec3 origin(world.origin), eye = origin + double(world.side) * glm::dvec3(1.5, 2.2, 4.5);
  Instant instant;
  instant.eye = eye;
  instant.camera = glm::conjugate(glm::dquat(glm::lookAt(
      glm::dvec3(0), origin + glm::dvec3(0, 0.3 * double(world.side), 0) - eye, glm::dvec3(0, 1, 0))));
  instant.near_plane = 0.05 * double(world.side);
  instant.vehicle = glm::translate(glm::dmat4(1), origin + moved);
  instant.towards_sun = glm::normalize(glm::dvec3(0.4, 0.8, 0.3));
  return instant;
}

FrameInput block_drive(uint32_t frame) {
  constexpr double speed = 0.37; // metres a frame
  const double rounds = std::floor(speed * frame / chequers);
  const auto at = [&](double moment) {
    const glm::dvec3 driven(0.3 * std::sin(moment / 40), 0, chequers * rounds - speed * moment);
    Instant instant = block_instant({}, driven);
    instant.eye += glm::dvec3(std::sin(moment / 23), 0, driven.z);
    return instant;
  };
  FrameInput input{.now = at(frame), .before = at(frame == 0 ? 0 : frame - 1.0)};
  input.index = frame, input.cut = frame == 0;
  return input;
}

} // namespace unghost
