// The little that stands between us and the C API: owners that destroy what they hold, and results that are
// checked.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include <vulkan/vulkan.h>

namespace unghost {

enum class GpuFault { no_device, lost, out_of_memory, other };

/// The device's fault; `what()` is a sentence that says what to do.
struct GpuError : std::runtime_error {
  GpuError(GpuFault kind, const std::string& sentence) : std::runtime_error(sentence), fault(kind) {}
  GpuFault fault;
};

/// Throws GpuError where `result` is an error; `doing` completes "Vulkan failed while ...".
void check(VkResult result, const char* doing);

/// Owns one handle of a device, and destroys it with `Destroy`.
template <class Handle, auto Destroy> class Owned {
public:
  Owned() = default;
  Owned(VkDevice device, Handle handle) : device_(device), handle_(handle) {}
  Owned(Owned&& other) noexcept
      : device_(other.device_), handle_(std::exchange(other.handle_, VK_NULL_HANDLE)) {}
  Owned& operator=(Owned&& other) noexcept {
    std::swap(device_, other.device_);
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Owned() {
    if (handle_ != VK_NULL_HANDLE) Destroy(device_, handle_, nullptr);
  }
  operator Handle() const { return handle_; }

private:
  VkDevice device_ = VK_NULL_HANDLE;
  Handle handle_ = VK_NULL_HANDLE;
};

using OwnedMemory = Owned<VkDeviceMemory, vkFreeMemory>;
using OwnedImage = Owned<VkImage, vkDestroyImage>;
using OwnedView = Owned<VkImageView, vkDestroyImageView>;
using OwnedBuffer = Owned<VkBuffer, vkDestroyBuffer>;
using OwnedSampler = Owned<VkSampler, vkDestroySampler>;
using OwnedModule = Owned<VkShaderModule, vkDestroyShaderModule>;
using OwnedSetLayout = Owned<VkDescriptorSetLayout, vkDestroyDescriptorSetLayout>;
using OwnedLayout = Owned<VkPipelineLayout, vkDestroyPipelineLayout>;
using OwnedPipeline = Owned<VkPipeline, vkDestroyPipeline>;
using OwnedDescriptorPool = Owned<VkDescriptorPool, vkDestroyDescriptorPool>;
using OwnedCommandPool = Owned<VkCommandPool, vkDestroyCommandPool>;
using OwnedSemaphore = Owned<VkSemaphore, vkDestroySemaphore>;
using OwnedRenderPass = Owned<VkRenderPass, vkDestroyRenderPass>;
using OwnedFramebuffer = Owned<VkFramebuffer, vkDestroyFramebuffer>;
using OwnedSwapchain = Owned<VkSwapchainKHR, vkDestroySwapchainKHR>;
using OwnedFence = Owned<VkFence, vkDestroyFence>;
using OwnedQueryPool = Owned<VkQueryPool, vkDestroyQueryPool>;

} // namespace unghost
