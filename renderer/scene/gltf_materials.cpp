#include "renderer/scene/gltf_materials.h"

#include <algorithm>
#include <cmath>

namespace unghost::gltf {

namespace {

constexpr int nearest = TINYGLTF_TEXTURE_FILTER_NEAREST, linear = TINYGLTF_TEXTURE_FILTER_LINEAR;

const tinygltf::Value* find(const tinygltf::Value& object, const char* key) {
  return object.IsObject() && object.Has(key) ? &object.Get(key) : nullptr;
}

float number(const tinygltf::Value& object, const char* key, float otherwise) {
  const tinygltf::Value* value = find(object, key);
  return value && value->IsNumber() ? float(value->GetNumberAsDouble()) : otherwise;
}

glm::vec2 pair(const tinygltf::Value& object, const char* key, glm::vec2 otherwise) {
  const tinygltf::Value* value = find(object, key);
  if (!value || !value->IsArray() || value->ArrayLen() != 2) return otherwise;
  return {float(value->Get(0).GetNumberAsDouble()), float(value->Get(1).GetNumberAsDouble())};
}

float unit(double value) { return float(std::clamp(value, 0.0, 1.0)); }

/// offset * rotation * scale. Angles turn the image clockwise where v points down: Khronos'
/// TextureTransformTest tells this from the other reading of the extension's text.
glm::mat3x2 transform_of(const tinygltf::Value& extension) {
  const glm::vec2 offset = pair(extension, "offset", glm::vec2(0)),
                  scale = pair(extension, "scale", glm::vec2(1));
  const float angle = number(extension, "rotation", 0), c = std::cos(angle), s = std::sin(angle);
  return {c * scale.x, -s * scale.x, s * scale.y, c * scale.y, offset.x, offset.y};
}

Wrap wrap_of(int mode) {
  if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::clamp_to_edge;
  if (mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::mirrored_repeat;
  return Wrap::repeat;
}

void set_sampler(TextureUse& use, const tinygltf::Sampler& sampler) {
  const int minify = sampler.minFilter;
  const bool from_nearest_texel = minify == nearest ||
                                  minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                                  minify == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
  use.magnify = sampler.magFilter == nearest ? Filter::nearest : Filter::linear;
  use.minify = from_nearest_texel ? Filter::nearest : Filter::linear;
  use.mipmapped = minify != nearest && minify != linear;
  use.wrap_u = wrap_of(sampler.wrapS), use.wrap_v = wrap_of(sampler.wrapT);
}

class Reader {
public:
  Reader(const tinygltf::Model& model, Images& images, Warnings& warnings)
      : model_(model), images_(images), warnings_(warnings) {}

  Material material(const tinygltf::Material& from);

private:
  TextureUse texture(int index, int uv_set, const tinygltf::ExtensionMap& extensions);
  template <class Info> TextureUse texture(const Info& info) {
    return texture(info.index, info.texCoord, info.extensions);
  }
  TextureUse texture(const tinygltf::Value& extension, const char* key);
  void surface(Material& to, const tinygltf::Material& from);
  void alpha(Material& to, const tinygltf::Material& from);
  void extensions(Material& to, const tinygltf::Material& from);

  const tinygltf::Model& model_;
  Images& images_;
  Warnings& warnings_;
};

TextureUse Reader::texture(int index, int uv_set, const tinygltf::ExtensionMap& extensions) {
  TextureUse use;
  if (index < 0) return use;
  const tinygltf::Texture& texture = model_.textures[size_t(index)];
  if (texture.sampler >= 0) set_sampler(use, model_.samplers[size_t(texture.sampler)]);
  use.image = images_.use(texture.source);
  use.uv_set = uv_set;
  if (const auto it = extensions.find("KHR_texture_transform"); it != extensions.end()) {
    use.transform = transform_of(it->second);
    use.uv_set = int(number(it->second, "texCoord", float(uv_set)));
  }
  if (use.uv_set > 1) {
    warnings_.say("texture coordinates beyond the second set are not read; the first is used instead");
    use.uv_set = 0;
  }
  return use;
}

TextureUse Reader::texture(const tinygltf::Value& extension, const char* key) {
  const tinygltf::Value* info = find(extension, key);
  if (!info) return {};
  tinygltf::ExtensionMap extensions;
  if (const tinygltf::Value* nested = find(*info, "extensions")) {
    if (const auto* transform = find(*nested, "KHR_texture_transform")) {
      extensions["KHR_texture_transform"] = *transform;
    }
  }
  return texture(int(number(*info, "index", -1)), int(number(*info, "texCoord", 0)), extensions);
}

void Reader::surface(Material& to, const tinygltf::Material& from) {
  const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
  for (int i = 0; i < 4; ++i) to.base_colour[i] = std::max(0.0f, float(pbr.baseColorFactor[size_t(i)]));
  for (int i = 0; i < 3; ++i) to.emissive[i] = std::max(0.0f, float(from.emissiveFactor[size_t(i)]));
  to.metalness = unit(pbr.metallicFactor), to.roughness = unit(pbr.roughnessFactor);
  to.normal_scale = float(from.normalTexture.scale);
  to.occlusion_strength = unit(from.occlusionTexture.strength);
  to.double_sided = from.doubleSided;
  to.base_colour_texture = texture(pbr.baseColorTexture);
  to.metallic_roughness_texture = texture(pbr.metallicRoughnessTexture);
  to.normal_texture = texture(from.normalTexture);
  to.occlusion_texture = texture(from.occlusionTexture);
  to.emissive_texture = texture(from.emissiveTexture);
}

void Reader::alpha(Material& to, const tinygltf::Material& from) {
  to.alpha_cutoff = float(from.alphaCutoff);
  if (from.alphaMode == "MASK") {
    to.alpha_mode = AlphaMode::mask;
  } else if (from.alphaMode == "BLEND") {
    to.alpha_mode = AlphaMode::blend;
    warnings_.say("alpha blending is not supported: what should be seen through is drawn opaque");
  } else if (from.alphaMode != "OPAQUE") {
    warnings_.say("the alpha mode '" + printable(from.alphaMode) + "' is not known; OPAQUE is drawn");
  }
}

void Reader::extensions(Material& to, const tinygltf::Material& from) {
  to.unlit = from.extensions.contains("KHR_materials_unlit");
  if (const auto it = from.extensions.find("KHR_materials_emissive_strength"); it != from.extensions.end()) {
    to.emissive *= std::max(0.0f, number(it->second, "emissiveStrength", 1));
    for (int i = 0; i < 3; ++i)
      to.emissive[i] = std::min(to.emissive[i], 1e30f); // two finite factors may overflow
  }
  const auto it = from.extensions.find("KHR_materials_clearcoat");
  if (it == from.extensions.end()) return;
  to.clearcoat = unit(number(it->second, "clearcoatFactor", 0));
  to.clearcoat_roughness = unit(number(it->second, "clearcoatRoughnessFactor", 0));
  to.clearcoat_texture = texture(it->second, "clearcoatTexture");
  to.clearcoat_roughness_texture = texture(it->second, "clearcoatRoughnessTexture");
  if (find(it->second, "clearcoatNormalTexture")) {
    warnings_.say("the normal map of a clearcoat is not supported and left out");
  }
}

Material Reader::material(const tinygltf::Material& from) {
  Material to;
  to.name = from.name;
  surface(to, from);
  alpha(to, from);
  extensions(to, from);
  return to;
}

} // namespace

std::vector<Material> read_materials(const tinygltf::Model& model, Images& images, Warnings& warnings) {
  Reader reader(model, images, warnings);
  std::vector<Material> materials;
  materials.reserve(model.materials.size() + 1);
  for (const tinygltf::Material& material : model.materials) materials.push_back(reader.material(material));
  materials.emplace_back().name = "default";
  return materials;
}

} // namespace unghost::gltf
