// The one door through which a scene file comes in. A file is hostile until proven otherwise.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>

#include "renderer/scene/scene.h"

namespace unghost {

struct LoadLimits {
  uint64_t file_bytes = 256ull << 20;  // a .gltf, .glb, .bin or picture on disk
  uint64_t decoded_bytes = 1ull << 30; // all pictures together, as RGBA
  uint32_t image_side = 8192;          // pixels; the device's limit where that is smaller
  uint32_t json_depth = 64;
  uint64_t geometry_bytes = 1ull << 30; // all vertices and indices, as the scene holds them
  uint64_t read_bytes = 1ull << 30;     // all files together
  uint32_t elements = 1'000'000;        // of one kind: nodes, accessors, drawn primitives, ...
};

/// Why a file was refused: `file: why (at JSON pointer)` makes the sentence.
struct Refusal {
  std::string file;
  std::string pointer; // empty where no place in the JSON is to blame
  std::string why;
  bool out_of_memory = false; // the file may be a good one

  std::string sentence() const;
};

/// Reads glTF 2.0 (.gltf with data URIs or files beside it, .glb). Never throws for what the file holds; a
/// picture that is missing or broken becomes a checkerboard and a warning.
std::variant<Scene, Refusal> load_scene(const std::filesystem::path& file, const LoadLimits& limits = {});

} // namespace unghost
