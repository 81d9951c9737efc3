#include "renderer/gpu/swapchain.h"

#include <algorithm>

namespace unghost {
namespace {

OwnedSemaphore make_semaphore(VkDevice device) {
  const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  VkSemaphore made = VK_NULL_HANDLE;
  check(vkCreateSemaphore(device, &info, nullptr, &made), "making a semaphore");
  return {device, made};
}

VkSurfaceFormatKHR choose_format(const Device& device) {
  uint32_t count = 0;
  vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), device.surface(), &count, nullptr);
  std::vector<VkSurfaceFormatKHR> formats(count);
  vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), device.surface(), &count, formats.data());
  for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM})
    for (const VkSurfaceFormatKHR& one : formats)
      if (one.format == wanted && one.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) return one;
  throw GpuError(GpuFault::other, "this window shows no pictures of 8 bits a channel");
}

/// The backend of the panel wants a render pass. What is shown was copied there before, and is presented.
OwnedRenderPass make_overlay_pass(VkDevice device, VkFormat format) {
  const VkAttachmentDescription attachment{.format = format,
                                           .samples = VK_SAMPLE_COUNT_1_BIT,
                                           .loadOp = VK_ATTACHMENT_LOAD_OP_LOAD,
                                           .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                                           .stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                                           .stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                                           .initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL,
                                           .finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR};
  const VkAttachmentReference colour{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  const VkSubpassDescription subpass{.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                                     .colorAttachmentCount = 1,
                                     .pColorAttachments = &colour};
  const VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
                                    .attachmentCount = 1,
                                    .pAttachments = &attachment,
                                    .subpassCount = 1,
                                    .pSubpasses = &subpass};
  VkRenderPass made = VK_NULL_HANDLE;
  check(vkCreateRenderPass(device, &info, nullptr, &made), "making a render pass");
  return {device, made};
}

VkOffset3D corner_of(VkExtent2D extent) { return {int32_t(extent.width), int32_t(extent.height), 1}; }

} // namespace

Swapchain::Swapchain(Device& device, VkExtent2D size)
    : device_(device), format_(choose_format(device)),
      pass_(make_overlay_pass(device.handle(), format_.format)) {
  for (OwnedSemaphore& semaphore : acquired_) semaphore = make_semaphore(device.handle());
  resize(size);
}

Swapchain::~Swapchain() { device_.wait_idle(); }

void Swapchain::resize(VkExtent2D size) {
  device_.wait_idle();
  framebuffers_.clear();
  views_.clear();
  drawn_.clear();
  VkSurfaceCapabilitiesKHR can{};
  check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), device_.surface(), &can),
        "asking for the window's size");
  const bool knows = can.currentExtent.width != UINT32_MAX;
  extent_ = knows ? can.currentExtent : size;
  if (!knows) {
    extent_.width = std::clamp(size.width, can.minImageExtent.width, can.maxImageExtent.width);
    extent_.height = std::clamp(size.height, can.minImageExtent.height, can.maxImageExtent.height);
  }
  if (extent_.width == 0 || extent_.height == 0) { // minimised: nothing can be shown
    swapchain_ = {};
    return;
  }
  const uint32_t wanted = std::max(can.minImageCount + 1, uint32_t(frames_in_flight) + 1);
  const VkSwapchainCreateInfoKHR info{
      .sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR,
      .surface = device_.surface(),
      .minImageCount = can.maxImageCount == 0 ? wanted : std::min(wanted, can.maxImageCount),
      .imageFormat = format_.format,
      .imageColorSpace = format_.colorSpace,
      .imageExtent = extent_,
      .imageArrayLayers = 1,
      .imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT,
      .preTransform = can.currentTransform,
      .compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR,
      .presentMode = VK_PRESENT_MODE_FIFO_KHR,
      .clipped = VK_TRUE,
      .oldSwapchain = swapchain_};
  VkSwapchainKHR made = VK_NULL_HANDLE;
  check(vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &made), "making the window's images");
  swapchain_ = {device_.handle(), made};
  create_images();
}

void Swapchain::create_images() {
  uint32_t count = 0;
  vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr);
  images_.resize(count);
  check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, images_.data()),
        "getting the window's images");
  for (const VkImage image : images_) {
    const VkImageViewCreateInfo view_info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                          .image = image,
                                          .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                          .format = format_.format,
                                          .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(device_.handle(), &view_info, nullptr, &view), "making an image view");
    views_.emplace_back(device_.handle(), view);
    const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                       .renderPass = pass_,
                                       .attachmentCount = 1,
                                       .pAttachments = &view,
                                       .width = extent_.width,
                                       .height = extent_.height,
                                       .layers = 1};
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    check(vkCreateFramebuffer(device_.handle(), &info, nullptr, &framebuffer), "making a framebuffer");
    framebuffers_.emplace_back(device_.handle(), framebuffer);
    drawn_.push_back(make_semaphore(device_.handle()));
  }
}

bool Swapchain::acquire() {
  if (swapchain_ == VK_NULL_HANDLE) return false;
  const VkResult result = vkAcquireNextImageKHR(device_.handle(), swapchain_, UINT64_MAX, acquired_[flight_],
                                                VK_NULL_HANDLE, &image_);
  if (result == VK_ERROR_OUT_OF_DATE_KHR) return false;
  check(result, "getting an image of the window");
  return true;
}

VkImageMemoryBarrier2 Swapchain::barrier() const {
  return {.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2,
          .srcStageMask = VK_PIPELINE_STAGE_2_BLIT_BIT, // where the submission waits for the image
          .dstStageMask = VK_PIPELINE_STAGE_2_BLIT_BIT,
          .dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT,
          .oldLayout = VK_IMAGE_LAYOUT_UNDEFINED,
          .newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
          .srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
          .dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED,
          .image = images_[image_],
          .subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
}

void Swapchain::record(VkCommandBuffer commands, VkImage picture, VkExtent2D picture_size) const {
  const auto record_barrier = [&](const VkImageMemoryBarrier2& one) {
    const VkDependencyInfo info{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO,
                                .imageMemoryBarrierCount = 1,
                                .pImageMemoryBarriers = &one};
    vkCmdPipelineBarrier2(commands, &info);
  };
  record_barrier(barrier());
  constexpr VkImageSubresourceLayers layers{VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  // a window that has just become smaller shows what fits
  const VkExtent2D shown{std::min(picture_size.width, extent_.width - std::min(picture_x, extent_.width - 1)),
                         std::min(picture_size.height, extent_.height)};
  const VkOffset3D from{int32_t(std::min(picture_x, extent_.width - 1)), 0, 0};
  const VkImageBlit whole{.srcSubresource = layers,
                          .srcOffsets = {{}, corner_of(shown)},
                          .dstSubresource = layers,
                          .dstOffsets = {from, {from.x + int32_t(shown.width), int32_t(shown.height), 1}}};
  vkCmdBlitImage(commands, picture, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, images_[image_],
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &whole, VK_FILTER_NEAREST);
  VkImageMemoryBarrier2 to_overlay = barrier();
  to_overlay.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  to_overlay.dstStageMask = VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT;
  to_overlay.dstAccessMask = VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
  to_overlay.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  to_overlay.newLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  record_barrier(to_overlay);
  const VkRenderPassBeginInfo begin{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                    .renderPass = pass_,
                                    .framebuffer = framebuffers_[image_],
                                    .renderArea = {{}, extent_}};
  vkCmdBeginRenderPass(commands, &begin, VK_SUBPASS_CONTENTS_INLINE);
  if (overlay) overlay(commands);
  vkCmdEndRenderPass(commands);
}

void Swapchain::present() {
  const VkSemaphore wait = drawn_[image_];
  const VkSwapchainKHR swapchain = swapchain_;
  const VkPresentInfoKHR info{.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR,
                              .waitSemaphoreCount = 1,
                              .pWaitSemaphores = &wait,
                              .swapchainCount = 1,
                              .pSwapchains = &swapchain,
                              .pImageIndices = &image_};
  const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
  flight_ = (flight_ + 1) % acquired_.size();
  if (result != VK_ERROR_OUT_OF_DATE_KHR) check(result, "showing a frame"); // the next acquire says so
}

} // namespace unghost
