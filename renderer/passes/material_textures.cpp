#include "renderer/passes/material_textures.h"

#include "renderer/gpu/texture.h"

namespace unghost {
namespace {

constexpr uint32_t srgb_textures = 1u << TEXTURE_BASE_COLOUR | 1u << TEXTURE_EMISSIVE;

std::unique_ptr<GpuImage> upload(Device& device, const Image& source, bool srgb) {
  return std::make_unique<GpuImage>(
      upload_texture(device,
                     {.name = source.name,
                      .format = srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                      .extent = {source.width, source.height}},
                     std::as_bytes(std::span(source.rgba))));
}

VkSamplerAddressMode address(Wrap wrap) {
  switch (wrap) {
  case Wrap::repeat:
    return VK_SAMPLER_ADDRESS_MODE_REPEAT;
  case Wrap::mirrored_repeat:
    return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
  case Wrap::clamp_to_edge:
    return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  }
  return VK_SAMPLER_ADDRESS_MODE_REPEAT;
}

VkFilter filter(Filter f) { return f == Filter::nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR; }

OwnedSetLayout make_layout(VkDevice device) {
  std::array<VkDescriptorSetLayoutBinding, MATERIAL_TEXTURES> bindings;
  for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i)
    bindings[i] = {i, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1, VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
  const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                             .bindingCount = MATERIAL_TEXTURES,
                                             .pBindings = bindings.data()};
  VkDescriptorSetLayout made = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device, &info, nullptr, &made), "making a material's layout");
  return {device, made};
}

OwnedDescriptorPool make_pool(VkDevice device, uint32_t sets) {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, sets * MATERIAL_TEXTURES};
  const VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = sets,
                                        .poolSizeCount = 1,
                                        .pPoolSizes = &size};
  VkDescriptorPool made = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device, &info, nullptr, &made), "making the materials' sets");
  return {device, made};
}

} // namespace

MaterialTextures::MaterialTextures(Device& device, const Scene& scene)
    : layout_(make_layout(device.handle())),
      pool_(make_pool(device.handle(), uint32_t(scene.materials.size()))) {
  const VkDescriptorSetLayout one = layout_;
  for (const Material& material : scene.materials) {
    const VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                           .descriptorPool = pool_,
                                           .descriptorSetCount = 1,
                                           .pSetLayouts = &one};
    VkDescriptorSet set = VK_NULL_HANDLE;
    check(vkAllocateDescriptorSets(device.handle(), &info, &set), "making a material's set");
    std::array<VkDescriptorImageInfo, MATERIAL_TEXTURES> images;
    for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i) {
      const TextureUse& use = material.*material_textures[i];
      images[i] = {sampler(device, use),
                   image(device, scene, {use.image, (srgb_textures >> i & 1) != 0}).view,
                   VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    }
    std::array<VkWriteDescriptorSet, MATERIAL_TEXTURES> writes;
    for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i)
      writes[i] = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                   .dstSet = set,
                   .dstBinding = i,
                   .descriptorCount = 1,
                   .descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                   .pImageInfo = &images[i]};
    vkUpdateDescriptorSets(device.handle(), MATERIAL_TEXTURES, writes.data(), 0, nullptr);
    sets_.push_back(set);
  }
}

const GpuImage& MaterialTextures::image(Device& device, const Scene& scene, ImageKey key) {
  if (key.image < 0) key = {-1, false}; // all slots without a picture share one white texel
  auto& place = images_[key];
  if (place == nullptr) {
    const Image white{.name = "white", .width = 1, .height = 1, .rgba = {255, 255, 255, 255}};
    place = upload(device, key.image < 0 ? white : scene.images[size_t(key.image)], key.srgb);
  }
  return *place;
}

VkSampler MaterialTextures::sampler(const Device& device, const TextureUse& use) {
  OwnedSampler& place =
      samplers_[{int(use.magnify), int(use.minify), use.mipmapped, int(use.wrap_u), int(use.wrap_v)}];
  if (place == VK_NULL_HANDLE) {
    const VkSamplerCreateInfo info{.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO,
                                   .magFilter = filter(use.magnify),
                                   .minFilter = filter(use.minify),
                                   .mipmapMode = use.mipmapped ? VK_SAMPLER_MIPMAP_MODE_LINEAR
                                                               : VK_SAMPLER_MIPMAP_MODE_NEAREST,
                                   .addressModeU = address(use.wrap_u),
                                   .addressModeV = address(use.wrap_v),
                                   .maxLod = use.mipmapped ? VK_LOD_CLAMP_NONE : 0.25f};
    VkSampler made = VK_NULL_HANDLE;
    check(vkCreateSampler(device.handle(), &info, nullptr, &made), "making a sampler");
    place = OwnedSampler(device.handle(), made);
  }
  return place;
}

} // namespace unghost
