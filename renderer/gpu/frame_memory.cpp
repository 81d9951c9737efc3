#include "renderer/gpu/frame_memory.h"

#include <algorithm>

namespace unghost {
namespace {

constexpr VkDeviceSize block_bytes = 256 << 10;

} // namespace

BufferSlice FrameMemory::push(std::span<const std::byte> bytes) {
  const VkDeviceSize size = std::max<VkDeviceSize>(bytes.size(), 16);
  while (block_ != blocks_.end() && used_ + size > block_->size) {
    ++block_;
    used_ = 0;
  }
  if (block_ == blocks_.end()) {
    blocks_.emplace_back(device_, std::max(size, block_bytes),
                         VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    block_ = std::prev(blocks_.end());
    used_ = 0;
  }
  const BufferSlice slice{block_->buffer, used_, size};
  if (!bytes.empty()) std::memcpy(block_->bytes().data() + used_, bytes.data(), bytes.size());
  const VkDeviceSize step = device_.buffer_alignment();
  used_ = (used_ + size + step - 1) / step * step;
  return slice;
}

void FrameMemory::reset() {
  block_ = blocks_.begin();
  used_ = 0;
}

} // namespace unghost
