// What a shader does, read off its SPIR-V: what is left of it once its specialization constants are known is
// what the driver gets to see.
#pragma once

#include <cstdint>
#include <map>
#include <span>

namespace unghost {

/// Numbers of instructions.
struct ShaderContents {
  uint32_t instructions = 0;             // all of them, declarations included
  std::map<uint32_t, int> reads, writes; // of images, by the binding of the image
  std::map<uint32_t, int> functions;     // of GLSL.std.450, by their number there

  int fetches() const;
};

/// Of a module whose functions are inlined, as `specialized` leaves it.
ShaderContents contents_of(std::span<const uint32_t> spirv);

} // namespace unghost
