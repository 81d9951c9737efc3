// The Vulkan device: the one queue, and memory out of it. Knows no scene.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>

namespace unghost {

enum class GpuFault { no_device, lost, out_of_memory, other };

/// The device's fault; `what()` is a sentence that says what to do.
struct GpuError : std::runtime_error {
  GpuError(GpuFault kind, const std::string& sentence) : std::runtime_error(sentence), fault(kind) {}
  GpuFault fault;
};

/// What a device says of itself.
struct DeviceFacts {
  std::string name, driver, api_version;
  bool software = false;      // a CPU: its times are not a GPU's
  bool usable = false;        // has all that unghost needs
  std::string missing;        // what it lacks where it is not usable
};

struct DeviceRequest {
  std::string which;      // index or part of a name; empty: the first usable one, a GPU before a CPU
  bool validate = false;  // core and synchronization validation
};

/// Every device the loader finds, usable or not. Throws GpuError(no_device) where there is no loader or driver.
std::vector<DeviceFacts> list_devices();

class Device {
 public:
  explicit Device(const DeviceRequest& request);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const DeviceFacts& facts() const { return facts_; }
  /// What the validation layer has said so far.
  const std::vector<std::string>& validation_messages() const { return messages_; }

 private:
  DeviceFacts facts_;
  std::vector<std::string> messages_;
};

}  // namespace unghost
