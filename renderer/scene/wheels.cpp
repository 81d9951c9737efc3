#include "renderer/scene/wheels.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "renderer/scene/animation.h"
#include "renderer/scene/bounds.h"

namespace unghost {

namespace {

// A scene with more is no car, and each takes a walk over all nodes.
constexpr size_t most_wheels = 64;

/// Lower case, letters and digits only: "Wheel_Front.L" and "wheel front l" are the same.
std::string plain(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c))) out += char(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

bool has_any(std::string_view text, std::initializer_list<std::string_view> words) {
  return std::ranges::any_of(words, [&](std::string_view word) { return text.find(word) != text.npos; });
}

/// Of each node, whether it or a node below it draws something.
std::vector<bool> nodes_that_draw(const Scene& scene) {
  std::vector<bool> draws(scene.nodes.size(), false);
  for (size_t i = scene.nodes.size(); i-- > 0;) {
    const Node& node = scene.nodes[i];
    draws[i] = draws[i] || (node.mesh >= 0 && !scene.meshes[size_t(node.mesh)].primitives.empty());
    if (draws[i] && node.parent >= 0) draws[size_t(node.parent)] = true;
  }
  return draws;
}

const std::string& name_of(const Scene& scene, size_t node) {
  const Node& named = scene.nodes[node];
  return named.name.empty() && named.mesh >= 0 ? scene.meshes[size_t(named.mesh)].name : named.name;
}

/// Nodes with a wheel's name. A node over several of them ("Wheels") is a group, and what is below a wheel is
/// part of it.
std::vector<int> wheel_nodes(const Scene& scene) {
  const std::vector<bool> draws = nodes_that_draw(scene);
  const size_t count = scene.nodes.size();
  std::vector<bool> named(count), part(count, false);
  std::vector<int> branches(count, 0); // children with a wheel at or below them
  for (size_t i = count; i-- > 0;) {
    named[i] = draws[i] && is_wheel_name(name_of(scene, i));
    const int parent = scene.nodes[i].parent;
    if (parent >= 0 && (named[i] || branches[i] > 0)) ++branches[size_t(parent)];
  }
  std::vector<int> wheels;
  for (size_t i = 0; i < count && wheels.size() < most_wheels; ++i) {
    const int parent = scene.nodes[i].parent;
    part[i] = parent >= 0 && part[size_t(parent)];
    if (part[i] || !named[i] || branches[i] > 1) continue;
    wheels.push_back(int(i));
    part[i] = true;
  }
  return wheels;
}

/// A matrix stands above the rotation that turns a wheel: it becomes its translation, rotation and scale,
/// where it is no more than these.
void take_matrix_apart(Node& node) {
  if (!node.matrix) return;
  const glm::mat4 matrix = *node.matrix;
  glm::mat3 axes(matrix);
  Trs local{.translation = glm::vec3(matrix[3]),
            .scale = {glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])}};
  if (glm::determinant(axes) < 0) local.scale.x = -local.scale.x;
  for (int i = 0; i < 3; ++i) axes[i] /= local.scale[i];
  local.rotation = glm::normalize(glm::quat_cast(axes));
  const glm::dmat4 again = matrix_of(local);
  const float largest = std::max({local.scale.y, local.scale.z, std::abs(local.scale.x)});
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) // written so that NaN is refused, too
      if (!(std::abs(again[column][row] - double(matrix[column][row])) <= 1e-4 * double(largest))) return;
  node.local = local;
  node.matrix.reset();
}

/// The radius of what a node draws, in its parent's space and without its own rotation; 0 where that is not
/// as high as it is long: then it does not roll about x.
float radius_of(const Scene& scene, int wheel) {
  Scene parts;
  parts.meshes = scene.meshes;
  const std::vector<bool> below = subtree_of(scene, wheel);
  std::vector<int> places(scene.nodes.size(), -1);
  for (size_t i = size_t(wheel); i < below.size(); ++i) {
    if (!below[i]) continue;
    places[i] = int(parts.nodes.size());
    parts.nodes.push_back(scene.nodes[i]);
    Node& node = parts.nodes.back();
    node.parent = int(i) == wheel ? -1 : places[size_t(node.parent)];
  }
  parts.nodes.front().local.rotation = glm::quat(1, 0, 0, 0);
  const Bounds box = scene_bounds(parts);
  const glm::vec3 size = box.high - box.low;
  constexpr float out_of_round = 0.1f;
  const float diameter = std::max(size.y, size.z);
  return std::abs(size.y - size.z) <= out_of_round * diameter && std::isfinite(diameter) ? diameter / 2 : 0;
}

} // namespace

bool is_wheel_name(std::string_view name) {
  const std::string text = plain(name);
  return has_any(text, {"wheel"}) && !has_any(text, {"steer", "arch", "well", "house", "housing", "base",
                                                     "barrow", "chair", "cover", "guard", "spare"});
}

void find_wheels_by_name(Scene& scene) {
  for (Node& node : scene.nodes)
    if (node.wheel) take_matrix_apart(node);
  if (std::ranges::any_of(scene.nodes, [](const Node& node) { return node.wheel.has_value(); })) return;
  const std::vector<int> wheels = wheel_nodes(scene);
  if (wheels.empty()) return;
  const auto is_front = [&](int node) { return has_any(plain(name_of(scene, size_t(node))), {"front"}); };
  const bool names_tell = std::ranges::any_of(wheels, is_front);
  const std::vector<glm::dmat4> world = world_matrices(scene, default_pose(scene));
  const auto z = [&](int node) { return world[size_t(node)][3].z; };
  const auto [rear, front] = std::ranges::minmax(wheels, {}, z);
  const double middle = 0.5 * (z(rear) + z(front));
  for (const int node : wheels) {
    take_matrix_apart(scene.nodes[size_t(node)]);
    const float radius = radius_of(scene, node);
    if (radius > 0) {
      scene.nodes[size_t(node)].wheel = Wheel{radius, names_tell ? is_front(node) : z(node) > middle};
    } else {
      const char* sentence =
          "what is named a wheel is not round about its x axis and does not roll with the car";
      if (std::ranges::find(scene.warnings, sentence) == scene.warnings.end())
        scene.warnings.push_back(sentence);
    }
  }
}

} // namespace unghost
