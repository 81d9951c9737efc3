#include "renderer/passes/material_textures.h"

#include <algorithm>
#include <bit>

namespace unghost {
namespace {

constexpr uint32_t srgb_textures = HAS_BASE_COLOUR | HAS_EMISSIVE;
constexpr VkImageUsageFlags texture_usage =
    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

void move_mip(VkCommandBuffer commands, VkImage image, uint32_t mip, VkImageLayout from, VkImageLayout to) {
  const VkImageMemoryBarrier2 barrier{
      .sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
      .srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT,
      .srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
      .dstStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
      .dstAccessMask = VK_ACCESS_2_TRANSFER_READ_BIT | VK_ACCESS_2_TRANSFER_WRITE_BIT |
                       VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
      .oldLayout = from,
      .newLayout = to,
      .image = image,
      .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 1, 0, 1}};
  const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                              .imageMemoryBarrierCount = 1,
                              .pImageMemoryBarriers = &barrier};
  vkCmdPipelineBarrier2(commands, &info);
}

VkOffset3D corner(const Image& image, uint32_t mip) {
  return {int32_t(std::max(image.width >> mip, 1u)), int32_t(std::max(image.height >> mip, 1u)), 1};
}

/// Mip 0 comes from `pixels`; each further one is half of the one before.
void fill_mips(VkCommandBuffer commands, const GpuImage& target, const Image& source, uint32_t mips,
               VkBuffer pixels) {
  for (uint32_t mip = 0; mip < mips; ++mip) {
    move_mip(commands, target.image, mip, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    if (mip == 0) {
      const VkBufferImageCopy copy{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                   .imageExtent = {source.width, source.height, 1}};
      vkCmdCopyBufferToImage(commands, pixels, target.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    } else {
      const VkImageBlit blit{.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, 1},
                             .srcOffsets = {{0, 0, 0}, corner(source, mip - 1)},
                             .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1},
                             .dstOffsets = {{0, 0, 0}, corner(source, mip)}};
      vkCmdBlitImage(commands, target.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.image,
                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    }
    move_mip(commands, target.image, mip, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
             VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  }
  for (uint32_t mip = 0; mip < mips; ++mip)
    move_mip(commands, target.image, mip, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
             VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
}

std::unique_ptr<GpuImage> upload(Device& device, const Image& source, bool srgb) {
  const uint32_t mips = uint32_t(std::bit_width(std::max(source.width, source.height)));
  auto target = std::make_unique<GpuImage>(
      device, GpuImageDesc{.name = source.name,
                           .format = srgb ? VK_FORMAT_R8G8B8A8_SRGB : VK_FORMAT_R8G8B8A8_UNORM,
                           .extent = {source.width, source.height},
                           .mips = mips,
                           .usage = texture_usage});
  const GpuBuffer pixels(device, source.rgba.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  std::memcpy(pixels.bytes().data(), source.rgba.data(), source.rgba.size());
  device.run([&](VkCommandBuffer commands) { fill_mips(commands, *target, source, mips, pixels.buffer); });
  return target;
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

std::array<const TextureUse*, MATERIAL_TEXTURES> textures_of(const Material& m) {
  return {&m.base_colour_texture,        &m.metallic_roughness_texture, &m.normal_texture,
          &m.occlusion_texture,          &m.emissive_texture,           &m.clearcoat_texture,
          &m.clearcoat_roughness_texture};
}

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
    const auto uses = textures_of(material);
    for (uint32_t i = 0; i < MATERIAL_TEXTURES; ++i)
      images[i] = {sampler(device, *uses[i]),
                   image(device, scene, {uses[i]->image, (srgb_textures >> i & 1) != 0}).view,
                   VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
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
                                   .mipmapMode = VK_SAMPLER_MIPMAP_MODE_LINEAR,
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
