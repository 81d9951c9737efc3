#include "renderer/gpu/instance.h"

#include <cstring>

namespace unghost {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

bool layer_is_there(const char* name) {
  uint32_t count = 0;
  vkEnumerateInstanceLayerProperties(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  vkEnumerateInstanceLayerProperties(&count, layers.data());
  for (const VkLayerProperties& layer : layers)
    if (std::strcmp(layer.layerName, name) == 0) return true;
  return false;
}

bool has_extension(VkPhysicalDevice physical, const char* name) {
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data());
  for (const VkExtensionProperties& extension : extensions)
    if (std::strcmp(extension.extensionName, name) == 0) return true;
  return false;
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                          VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* messages) {
  static_cast<std::vector<std::string>*>(messages)->push_back(data->pMessage);
  return VK_FALSE;
}

std::string version_text(uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) +
         "." + std::to_string(VK_API_VERSION_PATCH(version));
}

constexpr uint32_t most_attachments = 6; // of the G-buffer

/// Those of the frame's formats that Vulkan does not promise for what they are used as.
std::string missing_format(VkPhysicalDevice physical) {
  struct Needed {
    VkFormat format;
    VkFormatFeatureFlags features;
    const char* name;
  };
  constexpr VkFormatFeatureFlags drawn_and_read =
      VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT | VK_FORMAT_FEATURE_SAMPLED_IMAGE_BIT;
  for (const Needed& needed :
       {Needed{VK_FORMAT_B10G11R11_UFLOAT_PACK32, drawn_and_read, "drawing to B10G11R11"},
        Needed{VK_FORMAT_R16G16_SNORM, drawn_and_read, "drawing to R16G16_SNORM"},
        Needed{VK_FORMAT_D32_SFLOAT_S8_UINT, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT,
               "D32_SFLOAT_S8"}}) {
    VkFormatProperties properties{};
    vkGetPhysicalDeviceFormatProperties(physical, needed.format, &properties);
    if ((properties.optimalTilingFeatures & needed.features) != needed.features) return needed.name;
  }
  return {};
}

/// Of a device that is good for all else.
std::string missing_for_window(VkPhysicalDevice physical, VkSurfaceKHR surface) {
  if (!has_extension(physical, VK_KHR_SWAPCHAIN_EXTENSION_NAME)) return "VK_KHR_swapchain";
  VkBool32 presents = VK_FALSE;
  vkGetPhysicalDeviceSurfaceSupportKHR(physical, uint32_t(queue_family(physical).index), surface, &presents);
  return presents ? "" : "a queue that presents to this window";
}

std::string missing_of(VkPhysicalDevice physical, uint32_t api_version) {
  if (api_version < VK_API_VERSION_1_3) return "Vulkan 1.3";
  if (queue_family(physical).index < 0) return "a queue for graphics and compute with timestamps";
  if (!has_extension(physical, VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME)) return "VK_KHR_push_descriptor";
  if (const std::string format = missing_format(physical); !format.empty()) return format;
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical, &properties);
  if (properties.limits.maxColorAttachments < most_attachments) return "six colour attachments";
  Features features;
  vkGetPhysicalDeviceFeatures2(physical, &features.core);
  for (const NeededFeature& feature : needed_features())
    if (!feature.in(features)) return feature.name;
  return {};
}

} // namespace

Features::Features() {
  core.pNext = &vulkan12;
  vulkan12.pNext = &vulkan13;
}

const std::vector<NeededFeature>& needed_features() {
  static const std::vector<NeededFeature> needed{
      {"scalarBlockLayout", [](Features& f) -> VkBool32& { return f.vulkan12.scalarBlockLayout; }},
      {"hostQueryReset", [](Features& f) -> VkBool32& { return f.vulkan12.hostQueryReset; }},
      {"dynamicRendering", [](Features& f) -> VkBool32& { return f.vulkan13.dynamicRendering; }},
      {"synchronization2", [](Features& f) -> VkBool32& { return f.vulkan13.synchronization2; }},
      {"shaderStorageImageExtendedFormats",
       [](Features& f) -> VkBool32& { return f.core.features.shaderStorageImageExtendedFormats; }},
      {"robustBufferAccess", [](Features& f) -> VkBool32& { return f.core.features.robustBufferAccess; }},
      {"independentBlend", [](Features& f) -> VkBool32& { return f.core.features.independentBlend; }},
  };
  return needed;
}

VkInstance create_instance(bool validate, const std::vector<const char*>& of_window) {
  const VkApplicationInfo application{.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO,
                                      .pApplicationName = "unghost",
                                      .apiVersion = VK_API_VERSION_1_3};
  if (validate && !layer_is_there(validation_layer))
    throw GpuError(GpuFault::no_device, "the validation layer is not installed; on Debian it is the package "
                                        "vulkan-validationlayers");
  const VkValidationFeatureEnableEXT also[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
  const VkValidationFeaturesEXT validation{.sType = VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT,
                                           .enabledValidationFeatureCount = 1,
                                           .pEnabledValidationFeatures = also};
  std::vector<const char*> extensions = of_window;
  if (validate) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  const VkInstanceCreateInfo info{.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO,
                                  .pNext = validate ? &validation : nullptr,
                                  .pApplicationInfo = &application,
                                  .enabledLayerCount = validate ? 1u : 0u,
                                  .ppEnabledLayerNames = &validation_layer,
                                  .enabledExtensionCount = uint32_t(extensions.size()),
                                  .ppEnabledExtensionNames = extensions.data()};
  VkInstance instance = VK_NULL_HANDLE;
  if (vkCreateInstance(&info, nullptr, &instance) != VK_SUCCESS)
    throw GpuError(GpuFault::no_device, "no Vulkan driver was found; install one (on Debian: "
                                        "mesa-vulkan-drivers) or see VK_DRIVER_FILES");
  return instance;
}

VkDebugUtilsMessengerEXT listen(VkInstance instance, std::vector<std::string>& messages) {
  const VkDebugUtilsMessengerCreateInfoEXT info{
      .sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT,
      .messageSeverity =
          VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT,
      .messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT,
      .pfnUserCallback = on_message,
      .pUserData = &messages};
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  check(create(instance, &info, nullptr, &messenger), "listening to the validation layer");
  return messenger;
}

std::vector<VkPhysicalDevice> physical_devices(VkInstance instance) {
  uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  devices.resize(count);
  return devices;
}

QueueFamily queue_family(VkPhysicalDevice physical) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  constexpr VkQueueFlags both = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (uint32_t i = 0; i < count; ++i)
    if ((families[i].queueFlags & both) == both && families[i].timestampValidBits > 0)
      return {int(i), families[i].timestampValidBits};
  return {};
}

DeviceFacts facts_of(VkPhysicalDevice physical, VkSurfaceKHR surface) {
  VkPhysicalDeviceDriverProperties driver{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceProperties2 two{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, .pNext = &driver};
  vkGetPhysicalDeviceProperties2(physical, &two);
  DeviceFacts facts{.name = two.properties.deviceName,
                    .driver = std::string(driver.driverName) + " " + driver.driverInfo,
                    .api_version = version_text(two.properties.apiVersion),
                    .software = two.properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU};
  facts.missing = missing_of(physical, two.properties.apiVersion);
  if (facts.missing.empty() && surface != VK_NULL_HANDLE)
    facts.missing = missing_for_window(physical, surface);
  facts.usable = facts.missing.empty();
  return facts;
}

std::vector<DeviceFacts> list_devices() {
  const VkInstance instance = create_instance(false);
  std::vector<DeviceFacts> all;
  for (const VkPhysicalDevice physical : physical_devices(instance)) all.push_back(facts_of(physical));
  vkDestroyInstance(instance, nullptr);
  return all;
}

} // namespace unghost
