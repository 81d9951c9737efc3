// The Vulkan device: the one queue, and memory out of it. Knows no scene.
#pragma once

#include <array>
#include <functional>
#include <optional>
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

/// How a window makes its surface, and the instance's extensions that it needs for that.
struct SurfaceMaker {
  std::vector<const char*> extensions;
  std::function<VkSurfaceKHR(VkInstance)> make;
};

struct DeviceRequest {
  std::string which;                    // as chosen_device has it
  bool validate = false;                // core and synchronization validation
  std::optional<SurfaceMaker> window{}; // that the device can present to
};

/// Frames that the device may work on while the host makes the next.
constexpr size_t frames_in_flight = 2;

/// What submitted work waits for before it writes to a window's image, and signals when that can be shown.
struct SubmitSync {
  VkSemaphore wait = VK_NULL_HANDLE, signal = VK_NULL_HANDLE;
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
  VkInstance instance() const { return instance_; }
  VkPhysicalDevice physical() const { return physical_; }
  VkSurfaceKHR surface() const { return surface_; }
  VkQueue queue() const { return queue_; }
  uint32_t queue_family() const { return queue_family_; }
  /// Memory for `needs`, of the first type that has all of `wanted`, else all of `required`.
  OwnedMemory allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                       VkMemoryPropertyFlags wanted) const;
  using Record = std::function<void(VkCommandBuffer)>;
  /// Records, submits, and waits.
  void run(const Record& record);
  /// Records and submits; `flight` is less than frames_in_flight, and has been waited for.
  void submit(size_t flight, const Record& record, const SubmitSync& sync);
  /// For what was submitted there, if anything was; at most a minute: a hung device ends in GpuError(lost).
  void wait(size_t flight);
  /// Until nothing is at work.
  void wait_idle() const;
  /// vkCmdPushDescriptorSetKHR, which only the device can find.
  PFN_vkCmdPushDescriptorSetKHR push_descriptors = nullptr;
  /// A name for captures and validation messages; nothing where nobody listens.
  void name(uint64_t handle, VkObjectType type, const std::string& name) const;

private:
  /// A command buffer, and the fence of what it was last submitted with.
  struct Submission {
    VkCommandBuffer commands = VK_NULL_HANDLE;
    OwnedFence fence;
    bool pending = false;
  };
  static constexpr size_t by_itself = frames_in_flight; // the submission that `run` waits for

  void create_device();
  void create_submissions();
  void release(); // also what a constructor that fails half-way does

  std::vector<std::string> messages_;
  DeviceFacts facts_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  VkPhysicalDeviceMemoryProperties memory_{};
  uint64_t tick_mask_ = 0;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  uint32_t queue_family_ = 0;
  VkQueue queue_ = VK_NULL_HANDLE;
  OwnedCommandPool pool_;
  std::array<Submission, frames_in_flight + 1> submissions_;
  PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
};

} // namespace unghost
