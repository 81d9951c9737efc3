// What a screen shows, read from Xvfb's framebuffer.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace unghost {

struct Size {
  int width, height;
  bool operator==(const Size&) const = default;
};

struct Spot {
  int x, y; // in pixels from the upper left
};

using Colour = std::array<uint8_t, 3>; // 8-bit sRGB

struct Picture {
  Size size;
  std::vector<Colour> pixels; // row by row from above

  const Colour& at(Spot spot) const {
    return pixels.at(size_t(spot.y) * size_t(size.width) + size_t(spot.x));
  }
};

/// A part of the picture in an XWD file of 32-bit little-endian pixels, which is what Xvfb keeps its screen
/// in; pixels outside of the screen are an error.
Picture read_xwd(const std::filesystem::path& file, Spot corner, Size size);

/// For a person to look at, where a test failed.
void write_ppm(const Picture& picture, const std::filesystem::path& file);

} // namespace unghost
