// A Vulkan layer under which devices fail when a test wants them to. What it does stands in FAULTS, which
// nothing else reads: `submit=N` loses the device at the N-th submission, `wait=N` at the N-th wait for one,
// `memory=BYTES` refuses allocations that would come to more in all, and `count` says at the end, on standard
// error, how many submissions there were.
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <vulkan/vk_layer.h>
#include <vulkan/vulkan.h>

namespace {

// One instance and one device at a time is all that the program opens.
PFN_vkGetInstanceProcAddr next_of_instance;
PFN_vkGetDeviceProcAddr next_of_device;
VkInstance instance;
VkDevice device;
std::atomic<uint64_t> submissions, waits, allocated;
std::atomic<bool> lost;

/// The number after `name=` in FAULTS; never reached where there is none.
uint64_t limit_of(const char* name) {
  const char* faults = std::getenv("FAULTS");
  const char* found = faults != nullptr ? std::strstr(faults, name) : nullptr;
  return found != nullptr ? std::strtoull(found + std::strlen(name), nullptr, 10) : UINT64_MAX;
}

template <class Function> Function next(const char* name) {
  return reinterpret_cast<Function>(next_of_device(device, name));
}

/// The link of the chain that the loader made for this layer.
template <class Info> Info* link_of(const void* chain, VkStructureType type) {
  auto* info = static_cast<Info*>(const_cast<void*>(chain));
  while (info != nullptr && !(info->sType == type && info->function == VK_LAYER_LINK_INFO))
    info = static_cast<Info*>(const_cast<void*>(info->pNext));
  return info;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* allocator, VkInstance* made) {
  auto* link = link_of<VkLayerInstanceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
  if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
  next_of_instance = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create =
      reinterpret_cast<PFN_vkCreateInstance>(next_of_instance(VK_NULL_HANDLE, "vkCreateInstance"));
  const VkResult result = create(info, allocator, made);
  if (result == VK_SUCCESS) instance = *made;
  return result;
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* allocator, VkDevice* made) {
  auto* link = link_of<VkLayerDeviceCreateInfo>(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
  if (link == nullptr) return VK_ERROR_INITIALIZATION_FAILED;
  next_of_device = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
  link->u.pLayerInfo = link->u.pLayerInfo->pNext;
  const auto create = reinterpret_cast<PFN_vkCreateDevice>(next_of_instance(instance, "vkCreateDevice"));
  const VkResult result = create(physical, info, allocator, made);
  if (result == VK_SUCCESS) device = *made;
  return result;
}

VKAPI_ATTR void VKAPI_CALL destroy_device(VkDevice gone, const VkAllocationCallbacks* allocator) {
  const char* faults = std::getenv("FAULTS");
  if (faults != nullptr && std::strcmp(faults, "count") == 0)
    std::fprintf(stderr, "submissions: %llu\n", static_cast<unsigned long long>(submissions));
  next<PFN_vkDestroyDevice>("vkDestroyDevice")(gone, allocator);
}

VKAPI_ATTR VkResult VKAPI_CALL queue_submit(VkQueue queue, uint32_t count, const VkSubmitInfo2* submits,
                                            VkFence fence) {
  static const uint64_t last = limit_of("submit=");
  if (++submissions >= last) lost = true;
  if (lost) return VK_ERROR_DEVICE_LOST;
  return next<PFN_vkQueueSubmit2>("vkQueueSubmit2")(queue, count, submits, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL wait_for_fences(VkDevice of, uint32_t count, const VkFence* fences,
                                               VkBool32 all, uint64_t timeout) {
  static const uint64_t last = limit_of("wait=");
  // the work itself is waited for: what it uses may be destroyed after a device is lost
  const VkResult result = next<PFN_vkWaitForFences>("vkWaitForFences")(of, count, fences, all, timeout);
  if (++waits >= last) lost = true;
  return lost ? VK_ERROR_DEVICE_LOST : result;
}

VKAPI_ATTR VkResult VKAPI_CALL allocate_memory(VkDevice of, const VkMemoryAllocateInfo* info,
                                               const VkAllocationCallbacks* allocator, VkDeviceMemory* made) {
  static const uint64_t most = limit_of("memory=");
  if (allocated + info->allocationSize > most) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  allocated += info->allocationSize;
  return next<PFN_vkAllocateMemory>("vkAllocateMemory")(of, info, allocator, made);
}

template <class Function> PFN_vkVoidFunction as_void(Function function) {
  return reinterpret_cast<PFN_vkVoidFunction>(function);
}

PFN_vkVoidFunction ours(const char* name) {
  const std::string_view asked = name;
  if (asked == "vkCreateInstance") return as_void(create_instance);
  if (asked == "vkCreateDevice") return as_void(create_device);
  if (asked == "vkDestroyDevice") return as_void(destroy_device);
  if (asked == "vkQueueSubmit2") return as_void(queue_submit);
  if (asked == "vkWaitForFences") return as_void(wait_for_fences);
  if (asked == "vkAllocateMemory") return as_void(allocate_memory);
  return nullptr;
}

} // namespace

extern "C" {

__attribute__((visibility("default"))) PFN_vkVoidFunction VKAPI_CALL vkGetDeviceProcAddr(VkDevice of,
                                                                                         const char* name) {
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return as_void(vkGetDeviceProcAddr);
  const PFN_vkVoidFunction own = ours(name);
  return own != nullptr ? own : next_of_device(of, name);
}

__attribute__((visibility("default"))) PFN_vkVoidFunction VKAPI_CALL vkGetInstanceProcAddr(VkInstance of,
                                                                                           const char* name) {
  if (std::strcmp(name, "vkGetInstanceProcAddr") == 0) return as_void(vkGetInstanceProcAddr);
  if (std::strcmp(name, "vkGetDeviceProcAddr") == 0) return as_void(vkGetDeviceProcAddr);
  const PFN_vkVoidFunction own = ours(name);
  return own != nullptr || next_of_instance == nullptr ? own : next_of_instance(of, name);
}
}
