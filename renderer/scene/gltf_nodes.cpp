#include "renderer/scene/gltf_nodes.h"

#include <algorithm>

#include "renderer/scene/gltf_extras.h"

namespace unghost::gltf {

namespace {

using Model = tinygltf::Model;

/// The parent of each node, -1 for roots. With one parent at most, what has no cycle is a forest.
std::vector<int> parents_of(const Model& model) {
  std::vector<int> parents(model.nodes.size(), -1);
  for (size_t i = 0; i < model.nodes.size(); ++i) {
    for (size_t c = 0; c < model.nodes[i].children.size(); ++c) {
      int& parent = parents[size_t(model.nodes[i].children[c])];
      const std::string pointer = pointer_to("nodes", i, "children") + "/" + std::to_string(c);
      if (model.nodes[i].children[c] == int(i)) refuse("a node is its own child", pointer);
      if (parent >= 0) refuse("a node has two parents", pointer);
      parent = int(i);
    }
  }
  return parents;
}

/// Nodes below `roots`, parents first.
std::vector<int> in_order(const Model& model, std::vector<int> roots) {
  std::vector<int> order = std::move(roots);
  for (size_t i = 0; i < order.size(); ++i) {
    const std::vector<int>& children = model.nodes[size_t(order[i])].children;
    order.insert(order.end(), children.begin(), children.end());
  }
  return order;
}

std::vector<int> check_forest(const Model& model) {
  std::vector<int> parents = parents_of(model), roots;
  for (size_t i = 0; i < parents.size(); ++i) {
    if (parents[i] < 0) roots.push_back(int(i));
  }
  const std::vector<int> reached = in_order(model, roots);
  if (reached.size() == model.nodes.size()) return roots;
  // What no root reaches goes round in circles.
  std::vector<bool> is_reached(model.nodes.size(), false);
  for (const int node : reached) is_reached[size_t(node)] = true;
  const auto lost = std::find(is_reached.begin(), is_reached.end(), false) - is_reached.begin();
  refuse("the node is its own ancestor", pointer_to("nodes", size_t(lost)));
}

std::vector<int> roots_of_scene(const Model& model, int scene) {
  const std::vector<int>& roots = model.scenes[size_t(scene)].nodes;
  const std::vector<int> parents = parents_of(model);
  std::vector<bool> is_listed(model.nodes.size(), false);
  for (size_t i = 0; i < roots.size(); ++i) {
    const std::string pointer = pointer_to("scenes", size_t(scene), "nodes") + "/" + std::to_string(i);
    if (parents[size_t(roots[i])] >= 0) refuse("a scene's node is the child of another", pointer);
    if (is_listed[size_t(roots[i])]) refuse("a scene lists a node twice", pointer);
    is_listed[size_t(roots[i])] = true;
  }
  return roots;
}

glm::vec3 vec3_or(const std::vector<double>& numbers, glm::vec3 otherwise) {
  return numbers.size() == 3 ? glm::vec3(numbers[0], numbers[1], numbers[2]) : otherwise;
}

void set_transform(Node& node, const tinygltf::Node& from) {
  node.local.translation = vec3_or(from.translation, node.local.translation);
  node.local.scale = vec3_or(from.scale, node.local.scale);
  if (from.rotation.size() == 4) {
    const glm::dquat rotation(from.rotation[3], from.rotation[0], from.rotation[1], from.rotation[2]);
    const double length = glm::length(rotation);
    if (length > 0) node.local.rotation = glm::quat(rotation / length);
  }
  if (from.matrix.size() != 16) return;
  glm::mat4& matrix = node.matrix.emplace();
  for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = float(from.matrix[size_t(i)]);
}

int light_of(const tinygltf::Node& from) {
  const auto it = from.extensions.find("KHR_lights_punctual");
  if (it == from.extensions.end() || !it->second.Has("light")) return -1;
  return it->second.Get("light").GetNumberAsInt();
}

} // namespace

std::vector<int> read_nodes(Scene& scene, const Model& model, const LoadLimits& limits, Warnings& warnings) {
  std::vector<int> roots = check_forest(model);
  const int chosen = model.defaultScene >= 0 ? model.defaultScene : model.scenes.empty() ? -1 : 0;
  if (chosen >= 0) {
    roots = roots_of_scene(model, chosen);
    scene.name = model.scenes[size_t(chosen)].name;
    scene.track = track_of(model.scenes[size_t(chosen)].extras, warnings);
  }
  const std::vector<int> order = in_order(model, roots);
  std::vector<int> places(model.nodes.size(), -1);
  for (size_t i = 0; i < order.size(); ++i) places[size_t(order[i])] = int(i);

  uint64_t drawn = 0;
  scene.nodes.resize(order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    const tinygltf::Node& from = model.nodes[size_t(order[i])];
    Node& node = scene.nodes[i];
    node.name = from.name, node.mesh = from.mesh, node.camera = from.camera, node.light = light_of(from);
    set_transform(node, from);
    for (const int child : from.children) scene.nodes[size_t(places[size_t(child)])].parent = int(i);
    if (node.parent >= 0) node.tag = scene.nodes[size_t(node.parent)].tag;
    if (read_extras(node, from.extras, warnings)) scene.vehicle = int(i);
    if (node.mesh >= 0) drawn += scene.meshes[size_t(node.mesh)].primitives.size();
  }
  if (drawn > limits.elements)
    refuse("its nodes draw more than " + std::to_string(limits.elements) + " primitives");
  return places;
}

} // namespace unghost::gltf
