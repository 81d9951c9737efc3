#include "renderer/passes/gpu_scene.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "renderer/scene/bounds.h"
#include "shaders/shared/taa_key.h"

namespace unghost {
namespace {

template <class T>
GpuBuffer upload(const Device& device, const std::vector<T>& values, VkBufferUsageFlags usage) {
  GpuBuffer buffer(device, values.size() * sizeof(T), usage);
  if (!values.empty()) std::memcpy(buffer.bytes().data(), values.data(), values.size() * sizeof(T));
  return buffer;
}

uint32_t features_of(const Material& material) {
  uint32_t features = 0;
  for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i) {
    const TextureUse& use = material.*material_textures[i];
    if (use.image < 0) continue;
    features |= 1u << i;
    if (use.uv_set != 0 || use.transform != TextureUse{}.transform) features |= HAS_TEXTURE_PLACES;
  }
  if (material.alpha_mode == AlphaMode::mask) features |= HAS_ALPHA_MASK;
  if (material.unlit) features |= IS_UNLIT;
  return features;
}

bool shines(const Material& material) {
  return material.unlit || material.emissive != glm::vec3(0) || material.emissive_texture.image >= 0;
}

std::vector<MaterialData> material_data(const Scene& scene) {
  std::vector<MaterialData> all;
  for (const Material& m : scene.materials)
    all.push_back({.base_colour = m.base_colour,
                   .emissive = m.emissive,
                   .metalness = m.metalness,
                   .roughness = m.roughness,
                   .coat = m.clearcoat,
                   .coat_roughness = m.clearcoat_roughness,
                   .normal_scale = m.normal_scale,
                   .occlusion_strength = m.occlusion_strength,
                   // what is not masked passes the test where everything is tested
                   .alpha_cutoff = m.alpha_mode == AlphaMode::mask ? m.alpha_cutoff : 0});
  return all;
}

std::vector<TexturePlaces> places_of_textures(const Scene& scene) {
  std::vector<TexturePlaces> all;
  for (const Material& material : scene.materials) {
    TexturePlaces places{};
    for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i) {
      const TextureUse& use = material.*material_textures[i];
      places.uv_transforms[i] = use.transform;
      if (use.uv_set == 1) places.uv_sets |= 1u << i;
    }
    all.push_back(places);
  }
  return all;
}

/// By node, the one that it moves with: itself or its nearest ancestor that a rig or an animation moves; -1:
/// it rests.
std::vector<int> movers_of(const Scene& scene) {
  std::vector<int> movers(scene.nodes.size(), -1);
  std::vector<bool> moves(scene.nodes.size());
  for (const Animation& animation : scene.animations)
    for (const AnimationTrack& track : animation.tracks) moves[size_t(track.node)] = true;
  if (scene.vehicle >= 0) moves[size_t(scene.vehicle)] = true;
  for (size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    movers[n] = moves[n] || node.wheel ? int(n) : node.parent < 0 ? -1 : movers[size_t(node.parent)];
  }
  return movers;
}

/// Ids in turn: bodies that move have theirs, and so has each object that rests.
std::vector<uint32_t> words_of(const Scene& scene, const std::vector<int>& object_nodes) {
  const std::vector<int> movers = movers_of(scene);
  std::map<int, uint32_t> bodies;
  const auto body_of = [&](int mover) {
    return bodies.emplace(mover, uint32_t(bodies.size())).first->second;
  };
  uint32_t resting = 0;
  std::vector<uint32_t> words;
  for (const int node : object_nodes) {
    const int mover = movers[size_t(node)];
    const uint32_t id = mover < 0 ? 1 + resting++ % RESTING_IDS
                                  : 1 + RESTING_IDS + body_of(mover) % (OBJECT_IDS - RESTING_IDS);
    words.push_back(uint32_t(node + 1) | id << OBJECT_ID_SHIFT);
  }
  return words;
}

} // namespace

GpuScene::GpuScene(Device& device, const Scene& scene)
    : software(device.facts().software), materials(material_data(scene)),
      vertices(upload(device, scene.vertices, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT)),
      indices(upload(device, scene.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT)),
      texture_places(upload(device, places_of_textures(scene), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)),
      textures(device, scene) {
  for (size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (node.mesh < 0) continue;
    for (const Primitive& primitive : scene.meshes[size_t(node.mesh)].primitives) {
      const Material& material = scene.materials[size_t(primitive.material)];
      draws.push_back({.object = uint32_t(object_nodes.size()),
                       .first_index = primitive.first_index,
                       .index_count = primitive.index_count,
                       .first_vertex = primitive.first_vertex,
                       .material = uint32_t(primitive.material),
                       .features = features_of(material),
                       .tag = node.tag,
                       .double_sided = material.double_sided,
                       .blended = material.alpha_mode == AlphaMode::blend,
                       .shines = shines(material),
                       .bounds = primitive.bounds});
      traits.tagged |= node.tag != 0;
      traits.emissive |= draws.back().shines;
      traits.lit |= !material.unlit;
      traits.masked |= material.alpha_mode == AlphaMode::mask;
      traits.features &= draws.back().features;
    }
    object_nodes.push_back(int(n));
  }
  object_words = words_of(scene, object_nodes);
  vehicle = vehicle_bounds(scene);
  std::ranges::stable_sort(draws, {},
                           [](const Draw& draw) { return std::tuple(draw.features, draw.material); });
}

} // namespace unghost
