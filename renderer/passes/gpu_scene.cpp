#include "renderer/passes/gpu_scene.h"

#include <algorithm>
#include <tuple>

#include "renderer/scene/bounds.h"

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
  vehicle = vehicle_bounds(scene);
  std::ranges::stable_sort(draws, {},
                           [](const Draw& draw) { return std::tuple(draw.features, draw.material); });
}

} // namespace unghost
