// The envelope of a scene file: glTF's JSON as text, or in a .glb with a binary chunk.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace unghost::gltf {

/// The parts of a file; they point into the bytes it was opened from.
struct Container {
  std::string_view json;
  bool is_glb = false;
  std::optional<std::span<const uint8_t>> binary; // the BIN chunk of a .glb
};

/// Tells .glb from JSON by its first bytes, never by its name. Throws Refused.
Container open_container(std::span<const uint8_t> bytes);

} // namespace unghost::gltf
