// From what was wanted of a frame to the image that holds it, and from its bytes to numbers.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstring>
#include <vector>

#include "renderer/frame.h"

namespace unghost {

/// The element at `index` of what an image's texels were read back into.
template <class T> T element(const std::vector<std::byte>& bytes, size_t index = 0) {
  T value;
  assert((index + 1) * sizeof(T) <= bytes.size());
  std::memcpy(&value, bytes.data() + index * sizeof(T), sizeof(T));
  return value;
}

/// Asks the graph for it. Readbacks come in the order of asking.
void ask(FrameGraph& graph, const FrameImages& images, const Wanted& wanted);
/// `bytes` as the graph brought them for `what`.
Delivered deliver(const FrameInput& input, Output what, const std::vector<std::byte>& bytes);

} // namespace unghost
