// Memory for what the host tells the device each frame: constants, objects. Handed out in order, all given
// back at once.
#pragma once

#include <list>
#include <span>

#include "renderer/gpu/image.h"

namespace unghost {

class FrameMemory {
public:
  explicit FrameMemory(const Device& device) : device_(device) {}

  /// A copy of `bytes` that the device can read until `reset`.
  BufferSlice push(std::span<const std::byte> bytes);
  template <class T> BufferSlice push_value(const T& value) {
    return push(std::as_bytes(std::span(&value, 1)));
  }
  template <class T> BufferSlice push_range(const std::vector<T>& values) {
    return push(std::as_bytes(std::span(values)));
  }
  /// Only after the device has finished what used it.
  void reset();

private:
  const Device& device_;
  std::list<GpuBuffer> blocks_;
  std::list<GpuBuffer>::iterator block_ = blocks_.end();
  VkDeviceSize used_ = 0;
};

} // namespace unghost
