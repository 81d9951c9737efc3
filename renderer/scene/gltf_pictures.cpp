#include "renderer/scene/gltf_pictures.h"

#include <cstring>
#include <string>

namespace unghost::gltf {

void PictureBounds::take(uint64_t width, uint64_t height) {
  if (width == 0 || height == 0) throw BrokenPicture("it has no pixels");
  if (width > side || height > side) {
    throw BrokenPicture("it is " + std::to_string(width) + "x" + std::to_string(height) + "; " +
                        std::to_string(side) + " a side are allowed");
  }
  const uint64_t bytes = width * height * 4;
  if (bytes > bytes_left) throw BrokenPicture("all pictures together are too large");
  bytes_left -= bytes;
}

Image decode_picture(std::span<const uint8_t> bytes, PictureBounds& bounds) {
  const auto begins = [&](const char* signature, size_t size) {
    return bytes.size() >= size && std::memcmp(bytes.data(), signature, size) == 0;
  };
  if (begins("\x89PNG\r\n\x1a\n", 8)) return decode_png(bytes, bounds);
  if (begins("\xff\xd8\xff", 3)) return decode_jpeg(bytes, bounds);
  throw BrokenPicture("it is neither PNG nor JPEG");
}

Image checkerboard() {
  constexpr uint32_t side = 64, cell = 8;
  Image image{.name = "checkerboard", .width = side, .height = side, .rgba = {}};
  image.rgba.reserve(side * side * 4);
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      const bool odd = (x / cell + y / cell) % 2 != 0;
      image.rgba.insert(image.rgba.end(), {255, uint8_t(odd ? 255 : 0), 255, 255});
    }
  }
  return image;
}

} // namespace unghost::gltf
