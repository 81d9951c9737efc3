// Images and buffers: each owns its memory.
#pragma once

#include <cstring>
#include <span>

#include "renderer/gpu/device.h"

namespace unghost {

struct GpuImageDesc {
  std::string name;
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{1, 1};
  uint32_t mips = 1;
  VkImageUsageFlags usage = 0;
};

/// A 2D image with a view of all of it, and for depth-stencil formats a view of each aspect.
struct GpuImage {
  GpuImage(const Device& device, const GpuImageDesc& desc);

  OwnedMemory memory;
  OwnedImage image;
  OwnedView view;    // colour, or depth and stencil: what an attachment needs
  OwnedView depth;   // depth alone, for sampling
  OwnedView stencil; // stencil alone
  uint64_t bytes = 0;
};

bool is_depth(VkFormat format);
bool has_stencil(VkFormat format);
VkImageAspectFlags aspects_of(VkFormat format);
/// Bytes a texel of `aspect`, for those formats that are read back.
uint32_t texel_bytes(VkFormat format, VkImageAspectFlags aspect);

struct BufferSlice {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceSize offset = 0, size = 0;
};

/// A buffer that the host sees, on the device's own memory where the host can see that.
struct GpuBuffer {
  GpuBuffer(const Device& device, VkDeviceSize size, VkBufferUsageFlags usage,
            VkMemoryPropertyFlags wanted = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);

  BufferSlice all() const { return {buffer, 0, size}; }
  std::span<std::byte> bytes() const { return {static_cast<std::byte*>(mapped), size}; }

  VkDeviceSize size = 0;
  OwnedMemory memory; // unmapped by being freed
  OwnedBuffer buffer;
  void* mapped = nullptr;
};

} // namespace unghost
