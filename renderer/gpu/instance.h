// The Vulkan instance, the validation layer, and what is asked of a physical device.
#pragma once

#include <string>
#include <vector>

#include "renderer/gpu/device.h"

namespace unghost {

/// With the validation layer (core and synchronization) where `validate`, and the extensions of a window.
/// Throws GpuError(no_device).
VkInstance create_instance(bool validate, const std::vector<const char*>& extensions = {});
/// Appends every warning and error of the validation layer to `messages`.
VkDebugUtilsMessengerEXT listen(VkInstance instance, std::vector<std::string>& messages);
std::vector<VkPhysicalDevice> physical_devices(VkInstance instance);
/// `surface`: that it has to present to, if any.
DeviceFacts facts_of(VkPhysicalDevice physical, VkSurfaceKHR surface = VK_NULL_HANDLE);
/// The queue family with graphics, compute and timestamps; index -1 where there is none.
struct QueueFamily {
  int index = -1;
  uint32_t timestamp_bits = 0;
};
QueueFamily queue_family(VkPhysicalDevice physical);

/// The features that unghost cannot do without, chained for vkGetPhysicalDeviceFeatures2 and vkCreateDevice.
struct Features {
  VkPhysicalDeviceFeatures2 core{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  VkPhysicalDeviceVulkan12Features vulkan12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan13Features vulkan13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};

  Features();
  Features(const Features&) = delete;
};
/// Those of `Features` that are needed; used both to ask and to enable.
struct NeededFeature {
  const char* name;
  VkBool32& (*in)(Features&);
};
const std::vector<NeededFeature>& needed_features();

} // namespace unghost
