#include "renderer/gpu/image.h"

#include <algorithm>
#include <cassert>

namespace unghost {
namespace {

OwnedView view_of(VkDevice device, VkImage image, const GpuImageDesc& desc, VkImageAspectFlags aspect) {
  const VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                   .image = image,
                                   .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                   .format = desc.format,
                                   .subresourceRange = {aspect, 0, desc.mips, 0, 1}};
  VkImageView view = VK_NULL_HANDLE;
  check(vkCreateImageView(device, &info, nullptr, &view), "making an image's view");
  return {device, view};
}

} // namespace

bool is_depth(VkFormat format) { return format == VK_FORMAT_D32_SFLOAT || has_stencil(format); }
bool has_stencil(VkFormat format) { return format == VK_FORMAT_D32_SFLOAT_S8_UINT; }

VkImageAspectFlags aspects_of(VkFormat format) {
  if (!is_depth(format)) return VK_IMAGE_ASPECT_COLOR_BIT;
  return VK_IMAGE_ASPECT_DEPTH_BIT | (has_stencil(format) ? VK_IMAGE_ASPECT_STENCIL_BIT : 0);
}

uint32_t texel_bytes(VkFormat format, VkImageAspectFlags aspect) {
  if (aspect == VK_IMAGE_ASPECT_STENCIL_BIT) return 1;
  switch (format) {
  case VK_FORMAT_R8_UNORM:
  case VK_FORMAT_R8_UINT:
    return 1;
  case VK_FORMAT_R8G8B8A8_UNORM:
  case VK_FORMAT_R32_SFLOAT:
  case VK_FORMAT_R32_UINT:
  case VK_FORMAT_D32_SFLOAT:
  case VK_FORMAT_D32_SFLOAT_S8_UINT:
    return 4;
  case VK_FORMAT_R16G16B16A16_SFLOAT:
  case VK_FORMAT_R32G32_SFLOAT:
    return 8;
  case VK_FORMAT_R32G32B32A32_SFLOAT:
    return 16;
  default:
    assert(false && "a format that nobody reads back");
    return 0;
  }
}

GpuImage::GpuImage(const Device& device, const GpuImageDesc& desc) {
  const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                               .imageType = VK_IMAGE_TYPE_2D,
                               .format = desc.format,
                               .extent = {desc.extent.width, desc.extent.height, 1},
                               .mipLevels = desc.mips,
                               .arrayLayers = 1,
                               .samples = VK_SAMPLE_COUNT_1_BIT,
                               .tiling = VK_IMAGE_TILING_OPTIMAL,
                               .usage = desc.usage,
                               .initialLayout = VK_IMAGE_LAYOUT_UNDEFINED};
  VkImage made = VK_NULL_HANDLE;
  check(vkCreateImage(device.handle(), &info, nullptr, &made), "making an image");
  image = {device.handle(), made};
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device.handle(), image, &needs);
  memory = device.allocate(needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  bytes = needs.size;
  check(vkBindImageMemory(device.handle(), image, memory, 0), "binding an image's memory");
  device.name(reinterpret_cast<uint64_t>(made), VK_OBJECT_TYPE_IMAGE, desc.name);

  constexpr VkImageUsageFlags viewed = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT |
                                       VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
                                       VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
  if ((desc.usage & viewed) == 0) return;
  view = view_of(device.handle(), image, desc, aspects_of(desc.format));
  if (is_depth(desc.format)) depth = view_of(device.handle(), image, desc, VK_IMAGE_ASPECT_DEPTH_BIT);
  if (has_stencil(desc.format)) stencil = view_of(device.handle(), image, desc, VK_IMAGE_ASPECT_STENCIL_BIT);
}

GpuBuffer::GpuBuffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage,
                     VkMemoryPropertyFlags wanted)
    : size(std::max<VkDeviceSize>(bytes, 16)) {
  const VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = usage};
  VkBuffer made = VK_NULL_HANDLE;
  check(vkCreateBuffer(device.handle(), &info, nullptr, &made), "making a buffer");
  buffer = {device.handle(), made};
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device.handle(), buffer, &needs);
  memory = device.allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT,
                           wanted);
  check(vkBindBufferMemory(device.handle(), buffer, memory, 0), "binding a buffer's memory");
  check(vkMapMemory(device.handle(), memory, 0, VK_WHOLE_SIZE, 0, &mapped), "mapping a buffer");
}

} // namespace unghost
