// What a frame was made of, as plain data: for whoever shows it or measures it, and knows no Vulkan.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace unghost {

/// Counted in what is left of its shaders once their specialization constants are known.
struct UsedPipeline {
  std::string shader;              // file names; both of one that draws
  std::vector<uint32_t> constants; // specialization constants 0, 1, ...
  uint32_t instructions = 0;       // of SPIR-V, declarations included
  uint32_t fetches = 0;            // instructions that read a texel or sample
  uint32_t draws = 0;              // of geometry; 0 for a full-screen one

  bool operator==(const UsedPipeline&) const = default;
};

/// What a pass does with an image.
struct PassImage {
  std::string name;
  uint64_t bytes = 0;
  bool reads = false, writes = false;

  bool operator==(const PassImage&) const = default;
};

struct PassReport {
  std::string name;
  double ms = 0;                       // GPU time
  uint64_t image_bytes = 0;            // of the images that it is the first to touch
  std::vector<PassImage> images;       // but for those that stand for none
  std::vector<UsedPipeline> pipelines; // each once; none for a pass that copies
};

/// Images of passes that do not overlap share memory, and are named together.
struct UsedImage {
  std::string name;
  uint64_t bytes = 0;
};

/// What a frame was made without, and because of what.
struct LeftOut {
  std::string what, why;
};

/// How much of a frame is made: what its picture needs, or all that there is but for one thing, by the name
/// that it is left out under. The picture is the same to the bit.
struct Keeping {
  bool all = false;
  std::string but;
};

} // namespace unghost
