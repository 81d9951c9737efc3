// From what was wanted of a frame to the image that holds it, and from its bytes to numbers.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/frame.h"

namespace unghost {

/// Asks the graph for it. Readbacks come in the order of asking.
void ask(FrameGraph& graph, const FrameImages& images, const Wanted& wanted);
/// `bytes` as the graph brought them for `what`.
Delivered deliver(const FrameInput& input, Output what, const std::vector<std::byte>& bytes);

} // namespace unghost
