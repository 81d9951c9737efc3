// The Vulkan device: the one queue, and memory out of it. Knows no scene.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "renderer/gpu/vk.h"

namespace unghost {

/// What a device says of itself.
struct DeviceFacts {
  std::string name, driver, api_version;
  bool software = false; // a CPU: its times are not a GPU's
  bool usable = false;   // has all that unghost needs
  std::string missing;   // what it lacks where it is not usable
};

struct DeviceRequest {
  std::string which;     // as chosen_device has it
  bool validate = false; // core and synchronization validation
};

/// Every device the loader finds, usable or not. Throws GpuError(no_device) where there is no loader or
/// driver.
std::vector<DeviceFacts> list_devices();

/// Which of `all` a request for `which` gets: by index or part of a name; empty: the first usable one, a GPU
/// before a CPU. Throws GpuError(no_device).
size_t chosen_device(const std::vector<DeviceFacts>& all, const std::string& which);

class Device {
public:
  explicit Device(const DeviceRequest& request);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const DeviceFacts& facts() const { return facts_; }
  /// What the validation layer has said so far.
  const std::vector<std::string>& validation_messages() const { return messages_; }
  uint32_t largest_image_side() const { return properties_.limits.maxImageDimension2D; }
  /// Of a difference of timestamps: the bits that the queue counts with.
  uint64_t tick_mask() const { return tick_mask_; }
  double nanoseconds_per_tick() const { return properties_.limits.timestampPeriod; }
  uint64_t buffer_alignment() const;

  VkDevice handle() const { return device_; }
  /// Memory for `needs`, of the first type that has all of `wanted`, else all of `required`.
  OwnedMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                       VkMemoryPropertyFlags wanted) const;
  /// Records, submits, and waits, at most a minute: a hung device ends in GpuError(lost).
  void run(const std::function<void(VkCommandBuffer)>& record);
  /// vkCmdPushDescriptorSetKHR, which only the device can find.
  PFN_vkCmdPushDescriptorSetKHR push_descriptors = nullptr;
  /// A name for captures and validation messages; nothing where nobody listens.
  void name(uint64_t handle, VkObjectType type, const std::string& name) const;

private:
  void create_device(VkPhysicalDevice physical);
  void release(); // also what a constructor that fails half-way does

  std::vector<std::string> messages_;
  DeviceFacts facts_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  VkPhysicalDeviceMemoryProperties memory_{};
  uint64_t tick_mask_ = 0;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  OwnedCommandPool pool_;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  OwnedFence fence_;
  PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
};

} // namespace unghost
