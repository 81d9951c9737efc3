#include "renderer/gpu/device.h"

#include <algorithm>
#include <cassert>

#include "renderer/gpu/instance.h"

namespace unghost {
namespace {

// A GPU that takes longer hangs; a software device may just have been given much to do.
constexpr uint64_t longest_wait_ns = 60'000'000'000;

} // namespace

size_t chosen_device(const std::vector<DeviceFacts>& all, const std::string& which) {
  const bool by_index = !which.empty() && which.find_first_not_of("0123456789") == std::string::npos;
  for (size_t i = 0; i < all.size(); ++i) {
    const bool asked = which.empty() ? all[i].usable && !all[i].software
                       : by_index    ? which == std::to_string(i)
                                     : all[i].name.find(which) != std::string::npos;
    if (!asked) continue;
    if (!all[i].usable)
      throw GpuError(GpuFault::no_device, "the device " + all[i].name + " lacks " + all[i].missing);
    return i;
  }
  if (which.empty())
    for (size_t i = 0; i < all.size(); ++i)
      if (all[i].usable) return i;
  std::string sentence =
      which.empty() ? "no usable Vulkan device" : "no Vulkan device is called '" + which + "'";
  for (const DeviceFacts& facts : all)
    sentence += "; there is " + facts.name + (facts.usable ? "" : ", which lacks " + facts.missing);
  if (all.empty()) sentence += "; install a driver (on Debian: mesa-vulkan-drivers) or see VK_DRIVER_FILES";
  throw GpuError(GpuFault::no_device, sentence);
}

void check(VkResult result, const char* doing) {
  if (result >= VK_SUCCESS) return;
  const std::string what = std::string("Vulkan failed while ") + doing;
  switch (result) {
  case VK_ERROR_DEVICE_LOST:
    throw GpuError(GpuFault::lost, what + ": the device was lost");
  case VK_ERROR_OUT_OF_HOST_MEMORY:
  case VK_ERROR_OUT_OF_DEVICE_MEMORY:
    throw GpuError(GpuFault::out_of_memory, what + ": out of memory; try a smaller --size");
  default:
    throw GpuError(GpuFault::other, what + " (VkResult " + std::to_string(result) + ")");
  }
}

Device::Device(const DeviceRequest& request) {
  const bool in_window = request.window.has_value();
  instance_ =
      create_instance(request.validate, in_window ? request.window->extensions : std::vector<const char*>{});
  try {
    if (request.validate) messenger_ = listen(instance_, messages_);
    if (in_window) surface_ = request.window->make(instance_);
    const auto physical = physical_devices(instance_);
    std::vector<DeviceFacts> all;
    for (const VkPhysicalDevice one : physical) all.push_back(facts_of(one, surface_));
    const size_t chosen = chosen_device(all, request.which);
    facts_ = all[chosen];
    physical_ = physical[chosen];
    create_device();
    create_submissions();
    if (request.validate)
      set_name_ = reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(
          vkGetInstanceProcAddr(instance_, "vkSetDebugUtilsObjectNameEXT"));
  } catch (...) {
    release();
    throw;
  }
}

void Device::create_device() {
  vkGetPhysicalDeviceProperties(physical_, &properties_);
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
  Features features;
  for (const NeededFeature& feature : needed_features()) feature.in(features) = VK_TRUE;
  const QueueFamily chosen = unghost::queue_family(physical_);
  queue_family_ = uint32_t(chosen.index);
  tick_mask_ = chosen.timestamp_bits < 64 ? (uint64_t(1) << chosen.timestamp_bits) - 1 : ~uint64_t(0);
  const float priority = 1;
  const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                      .queueFamilyIndex = queue_family_,
                                      .queueCount = 1,
                                      .pQueuePriorities = &priority};
  std::vector<const char*> extensions = {VK_KHR_PUSH_DESCRIPTOR_EXTENSION_NAME};
  if (surface_ != VK_NULL_HANDLE) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                .pNext = &features.core,
                                .queueCreateInfoCount = 1,
                                .pQueueCreateInfos = &queue,
                                .enabledExtensionCount = uint32_t(extensions.size()),
                                .ppEnabledExtensionNames = extensions.data()};
  check(vkCreateDevice(physical_, &info, nullptr, &device_), "opening the device");
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
  push_descriptors = reinterpret_cast<PFN_vkCmdPushDescriptorSetKHR>(
      vkGetDeviceProcAddr(device_, "vkCmdPushDescriptorSetKHR"));
}

void Device::create_submissions() {
  const VkCommandPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                     .flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT,
                                     .queueFamilyIndex = queue_family_};
  VkCommandPool made = VK_NULL_HANDLE;
  check(vkCreateCommandPool(device_, &pool, nullptr, &made), "making a command pool");
  pool_ = {device_, made};
  const VkCommandBufferAllocateInfo allocation{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                               .commandPool = pool_,
                                               .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                               .commandBufferCount = 1};
  const VkFenceCreateInfo fence{.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
  for (Submission& submission : submissions_) {
    check(vkAllocateCommandBuffers(device_, &allocation, &submission.commands), "making a command buffer");
    VkFence signal = VK_NULL_HANDLE;
    check(vkCreateFence(device_, &fence, nullptr, &signal), "making a fence");
    submission.fence = {device_, signal};
  }
}

Device::~Device() { release(); }

void Device::release() {
  for (Submission& submission : submissions_) submission = {};
  pool_ = {};
  if (device_ != VK_NULL_HANDLE) vkDestroyDevice(device_, nullptr);
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vkGetInstanceProcAddr(instance_, "vkDestroyDebugUtilsMessengerEXT"));
    destroy(instance_, messenger_, nullptr);
  }
  if (surface_ != VK_NULL_HANDLE) vkDestroySurfaceKHR(instance_, surface_, nullptr);
  if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
}

uint64_t Device::buffer_alignment() const {
  return std::max({properties_.limits.minUniformBufferOffsetAlignment,
                   properties_.limits.minStorageBufferOffsetAlignment, VkDeviceSize{16}});
}

OwnedMemory Device::allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                             VkMemoryPropertyFlags wanted) const {
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  for (const VkMemoryPropertyFlags flags : {required | wanted, required})
    for (uint32_t type = 0; type < memory_.memoryTypeCount; ++type) {
      const bool fits = (needs.memoryTypeBits >> type & 1) != 0;
      if (!fits || (memory_.memoryTypes[type].propertyFlags & flags) != flags) continue;
      const VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO,
                                      .allocationSize = needs.size,
                                      .memoryTypeIndex = type};
      VkDeviceMemory memory = VK_NULL_HANDLE;
      result = vkAllocateMemory(device_, &info, nullptr, &memory);
      if (result == VK_SUCCESS) return {device_, memory}; // else a heap is full, and another may not be
    }
  check(result, "allocating memory");
  return {};
}

void Device::run(const Record& record) {
  submit(by_itself, record, {});
  wait(by_itself);
}

void Device::submit(size_t flight, const Record& record, const SubmitSync& sync) {
  Submission& submission = submissions_[flight];
  assert(!submission.pending);
  const VkCommandBufferBeginInfo begin{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                       .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  check(vkBeginCommandBuffer(submission.commands, &begin), "recording");
  try {
    record(submission.commands);
  } catch (...) {
    vkResetCommandBuffer(submission.commands, 0);
    throw;
  }
  check(vkEndCommandBuffer(submission.commands), "recording");
  const VkCommandBufferSubmitInfo buffer{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO,
                                         .commandBuffer = submission.commands};
  // a window's image is written at the very end, so that all before need not wait for it
  const VkSemaphoreSubmitInfo wait_for{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                       .semaphore = sync.wait,
                                       .stageMask = VK_PIPELINE_STAGE_2_BLIT_BIT};
  const VkSemaphoreSubmitInfo signals{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_SUBMIT_INFO,
                                      .semaphore = sync.signal,
                                      .stageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT};
  const VkSubmitInfo2 submit{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO_2,
                             .waitSemaphoreInfoCount = sync.wait != VK_NULL_HANDLE,
                             .pWaitSemaphoreInfos = &wait_for,
                             .commandBufferInfoCount = 1,
                             .pCommandBufferInfos = &buffer,
                             .signalSemaphoreInfoCount = sync.signal != VK_NULL_HANDLE,
                             .pSignalSemaphoreInfos = &signals};
  check(vkQueueSubmit2(queue_, 1, &submit, submission.fence), "submitting work");
  submission.pending = true;
}

void Device::wait(size_t flight) {
  Submission& submission = submissions_[flight];
  if (!submission.pending) return;
  const VkFence fence = submission.fence;
  const VkResult waited =
      vkWaitForFences(device_, 1, &fence, VK_TRUE, facts_.software ? UINT64_MAX : longest_wait_ns);
  if (waited == VK_TIMEOUT)
    throw GpuError(GpuFault::lost, "the device did not answer for a minute; try a smaller --size");
  check(waited, "waiting for the device");
  check(vkResetFences(device_, 1, &fence), "waiting for the device");
  submission.pending = false;
}

void Device::wait_idle() const { vkDeviceWaitIdle(device_); }

void Device::name(uint64_t handle, VkObjectType type, const std::string& name) const {
  if (set_name_ == nullptr) return;
  const VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT,
                                           .objectType = type,
                                           .objectHandle = handle,
                                           .pObjectName = name.c_str()};
  set_name_(device_, &info);
}

} // namespace unghost
