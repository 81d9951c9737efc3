// PNG and JPEG, decoded by the libraries made for it, within bounds that are checked on the header.
#pragma once

#include <cstdint>
#include <span>
#include <stdexcept>

#include "renderer/scene/scene.h"

namespace unghost::gltf {

/// A picture that cannot be shown: the message says why.
struct BrokenPicture : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct PictureBounds {
  uint32_t side = 0;       // pixels
  uint64_t bytes_left = 0; // of RGBA; what a picture takes is subtracted before it is decoded

  /// Throws BrokenPicture for a size that is not allowed.
  void take(uint64_t width, uint64_t height);
};

/// Tells the format by the first bytes, whatever a file or a document says. Gray, palette, 16 bits and
/// missing alpha become 8-bit RGBA; colour profiles are ignored, as glTF demands. Throws BrokenPicture.
Image decode_picture(std::span<const uint8_t> bytes, PictureBounds& bounds);
Image decode_png(std::span<const uint8_t> bytes, PictureBounds& bounds);
Image decode_jpeg(std::span<const uint8_t> bytes, PictureBounds& bounds);

/// What stands in for a picture that is missing or broken.
Image checkerboard();

} // namespace unghost::gltf
