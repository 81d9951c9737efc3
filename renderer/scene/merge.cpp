#include "renderer/scene/merge.h"

#include <algorithm>
#include <cassert>
#include <map>

#include "renderer/scene/bounds.h"

namespace unghost {

namespace {

int moved(int index, size_t offset) { return index < 0 ? -1 : index + int(offset); }

template <class T> void add_all(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void append_meshes(Scene& into, const Scene& from) {
  const size_t vertices = into.vertices.size(), indices = into.indices.size();
  const size_t materials = into.materials.size(), images = into.images.size();
  assert(vertices + from.vertices.size() <= UINT32_MAX && indices + from.indices.size() <= UINT32_MAX);
  add_all(into.vertices, from.vertices);
  add_all(into.indices, from.indices);
  add_all(into.images, from.images);
  for (Material material : from.materials) {
    for (const auto use : material_textures) (material.*use).image = moved((material.*use).image, images);
    into.materials.push_back(std::move(material));
  }
  for (Mesh mesh : from.meshes) {
    for (Primitive& primitive : mesh.primitives) {
      primitive.first_vertex += uint32_t(vertices), primitive.first_index += uint32_t(indices);
      primitive.material = moved(primitive.material, materials);
    }
    into.meshes.push_back(std::move(mesh));
  }
}

void append_nodes(Scene& into, const Scene& from, int parent_node, size_t first_mesh) {
  const size_t first = into.nodes.size(), cameras = into.cameras.size(), lights = into.lights.size();
  for (Node node : from.nodes) {
    node.parent = node.parent < 0 ? parent_node : moved(node.parent, first);
    node.mesh = moved(node.mesh, first_mesh);
    node.camera = moved(node.camera, cameras), node.light = moved(node.light, lights);
    if (node.tag == 0 && node.parent >= 0) node.tag = into.nodes[size_t(node.parent)].tag;
    into.nodes.push_back(std::move(node));
  }
  for (Animation animation : from.animations) {
    for (AnimationTrack& track : animation.tracks) track.node = moved(track.node, first);
    into.animations.push_back(std::move(animation));
  }
  add_all(into.cameras, from.cameras);
  add_all(into.lights, from.lights);
  if (into.vehicle < 0) into.vehicle = moved(from.vehicle, first);
}

/// Copies what is asked for, once, and remembers where it went.
class Sieve {
public:
  Sieve(const Scene& from, Scene& to) : from_(from), to_(to) {}

  int mesh(int index);
  int material(int index);

private:
  int image(int index);
  uint32_t vertices(const Primitive& primitive);

  const Scene& from_;
  Scene& to_;
  std::map<int, int> meshes_, materials_, images_;
  std::map<uint32_t, uint32_t> vertices_; // by first vertex: primitives share whole ranges or nothing
};

int Sieve::image(int index) {
  if (index < 0) return -1;
  const auto [at, is_new] = images_.try_emplace(index, int(to_.images.size()));
  if (is_new) to_.images.push_back(from_.images[size_t(index)]);
  return at->second;
}

int Sieve::material(int index) {
  const auto [at, is_new] = materials_.try_emplace(index, int(to_.materials.size()));
  if (!is_new) return at->second;
  Material copy = from_.materials[size_t(index)];
  for (const auto use : material_textures) (copy.*use).image = image((copy.*use).image);
  to_.materials.push_back(std::move(copy));
  return at->second;
}

uint32_t Sieve::vertices(const Primitive& primitive) {
  const auto [at, is_new] = vertices_.try_emplace(primitive.first_vertex, uint32_t(to_.vertices.size()));
  if (is_new) {
    const auto first = from_.vertices.begin() + primitive.first_vertex;
    to_.vertices.insert(to_.vertices.end(), first, first + primitive.vertex_count);
  }
  return at->second;
}

int Sieve::mesh(int index) {
  if (index < 0) return -1;
  const auto [at, is_new] = meshes_.try_emplace(index, int(to_.meshes.size()));
  if (!is_new) return at->second;
  Mesh copy = from_.meshes[size_t(index)];
  for (Primitive& primitive : copy.primitives) {
    const auto first = from_.indices.begin() + primitive.first_index;
    primitive.first_index = uint32_t(to_.indices.size());
    to_.indices.insert(to_.indices.end(), first, first + primitive.index_count);
    primitive.first_vertex = vertices(primitive);
    primitive.material = material(primitive.material);
  }
  to_.meshes.push_back(std::move(copy));
  return at->second;
}

void keep_tracks(const Scene& from, Scene& to, const std::vector<int>& places) {
  for (const Animation& animation : from.animations) {
    Animation kept;
    kept.name = animation.name;
    for (const AnimationTrack& track : animation.tracks) {
      if (places[size_t(track.node)] < 0) continue;
      kept.tracks.push_back(track);
      kept.tracks.back().node = places[size_t(track.node)];
      kept.duration = std::max(kept.duration, track.times.back());
    }
    if (!kept.tracks.empty()) to.animations.push_back(std::move(kept));
  }
}

} // namespace

int append(Scene& into, const Scene& from, int parent_node) {
  assert(&into != &from && parent_node < int(into.nodes.size()));
  const int first = int(into.nodes.size());
  const size_t first_mesh = into.meshes.size();
  append_meshes(into, from);
  append_nodes(into, from, parent_node, first_mesh);
  if (!into.track) into.track = from.track;
  for (const std::string& warning : from.warnings) {
    if (std::ranges::find(into.warnings, warning) == into.warnings.end()) into.warnings.push_back(warning);
  }
  return first;
}

Scene without(const Scene& scene, int node) {
  const std::vector<bool> removed = subtree_of(scene, node);
  Scene kept;
  kept.name = scene.name, kept.track = scene.track, kept.warnings = scene.warnings;
  kept.cameras = scene.cameras, kept.lights = scene.lights;
  Sieve sieve(scene, kept);
  std::vector<int> places(scene.nodes.size(), -1);
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    if (removed[i]) continue;
    places[i] = int(kept.nodes.size());
    Node copy = scene.nodes[i];
    if (copy.parent >= 0) copy.parent = places[size_t(copy.parent)];
    copy.mesh = sieve.mesh(copy.mesh);
    kept.nodes.push_back(std::move(copy));
  }
  if (kept.materials.empty()) sieve.material(0);
  keep_tracks(scene, kept, places);
  kept.vehicle = scene.vehicle >= 0 ? places[size_t(scene.vehicle)] : -1;
  return kept;
}

} // namespace unghost
