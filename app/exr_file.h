// Linear images as OpenEXR, 32-bit floats.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "renderer/frame_input.h"

namespace unghost {

/// One channel of a file: channel `component` of an image.
struct ExrChannel {
  std::string name; // "R", "Z", "motion.X", ...
  const FloatImage* image = nullptr;
  uint32_t component = 0;
};

/// All images have one size. `text` goes into the header attribute "unghost". Throws Failure(failed).
std::vector<uint8_t> encode_exr(const std::vector<ExrChannel>& channels, const std::string& text);

} // namespace unghost
