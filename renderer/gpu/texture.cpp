#include "renderer/gpu/texture.h"

#include <algorithm>
#include <bit>

namespace unghost {
namespace {

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

VkOffset3D corner(VkExtent2D extent, uint32_t mip) {
  return {int32_t(std::max(extent.width >> mip, 1u)), int32_t(std::max(extent.height >> mip, 1u)), 1};
}

/// Mip 0 comes from `pixels`; each further one is half of the one before.
void fill_mips(VkCommandBuffer commands, const GpuImage& target, VkExtent2D extent, uint32_t mips,
               VkBuffer pixels) {
  for (uint32_t mip = 0; mip < mips; ++mip) {
    move_mip(commands, target.image, mip, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    if (mip == 0) {
      const VkBufferImageCopy copy{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                   .imageExtent = {extent.width, extent.height, 1}};
      vkCmdCopyBufferToImage(commands, pixels, target.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &copy);
    } else {
      const VkImageBlit blit{.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, 1},
                             .srcOffsets = {{0, 0, 0}, corner(extent, mip - 1)},
                             .dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, 1},
                             .dstOffsets = {{0, 0, 0}, corner(extent, mip)}};
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

} // namespace

GpuImage upload_texture(Device& device, GpuImageDesc desc, std::span<const std::byte> texels) {
  desc.mips = uint32_t(std::bit_width(std::max(desc.extent.width, desc.extent.height)));
  desc.usage = texture_usage;
  GpuImage target(device, desc);
  const GpuBuffer staging(device, texels.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT, 0);
  std::memcpy(staging.bytes().data(), texels.data(), texels.size());
  device.run(
      [&](VkCommandBuffer commands) { fill_mips(commands, target, desc.extent, desc.mips, staging.buffer); });
  return target;
}

} // namespace unghost
