// Strips and fans as triangle lists, with the winding that glTF gives them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace unghost::gltf {

/// glTF's primitive modes.
enum class Topology { points, lines, line_loop, line_strip, triangles, strip, fan };

/// Three indices for each triangle; nothing for points and lines. Indices that make no whole triangle are
/// dropped.
std::vector<uint32_t> triangle_list(Topology topology, std::span<const uint32_t> indices);

} // namespace unghost::gltf
