// From a pixel that is probed to the images that hold it, and from their bytes to numbers.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "renderer/frame.h"

namespace unghost {

/// Asks the graph for what `probed` reads, after all else that it brings.
void ask_probe(FrameGraph& graph, const FrameImages& images, const FrameInput& input);
/// `readbacks` are the last ones that the graph brought.
ProbedPixel probed(const FrameInput& input, std::span<const std::vector<std::byte>> readbacks);
/// How many there are of them.
size_t probe_readbacks(const FrameInput& input);

} // namespace unghost
