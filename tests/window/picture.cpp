#include "tests/window/picture.h"

#include <fstream>
#include <stdexcept>

#include "tests/app/child.h"

namespace unghost {
namespace {

/// Words of an XWD header (X11/XWDFile.h), each 32-bit big-endian.
enum Word {
  header_size = 0,
  screen_width = 4,
  screen_height = 5,
  bits_per_pixel = 11,
  row_bytes = 12,
  colours = 19
};

constexpr size_t bytes_per_colour = 12; // of the colour table that follows the header

size_t word_of(const std::string& file, Word word) {
  size_t value = 0;
  for (size_t i = 0; i < 4; i++) value = value << 8 | uint8_t(file.at(size_t(word) * 4 + i));
  return value;
}

} // namespace

Picture read_xwd(const std::filesystem::path& file, Spot corner, Size size) {
  const std::string screen = content_of(file);
  if (screen.empty() || word_of(screen, bits_per_pixel) != 32)
    throw std::runtime_error(file.string() + " is no screen of 32-bit pixels");
  if (corner.x < 0 || corner.y < 0 || size_t(corner.x + size.width) > word_of(screen, screen_width) ||
      size_t(corner.y + size.height) > word_of(screen, screen_height))
    throw std::runtime_error("a picture was asked for that reaches beyond the screen");
  const size_t first = word_of(screen, header_size) + word_of(screen, colours) * bytes_per_colour;
  Picture picture{size, {}};
  picture.pixels.reserve(size_t(size.width) * size_t(size.height));
  for (int y = corner.y; y < corner.y + size.height; y++)
    for (int x = corner.x; x < corner.x + size.width; x++) {
      const size_t at =
          first + size_t(y) * word_of(screen, row_bytes) + size_t(x) * 4; // blue, green, red, unused
      picture.pixels.push_back(
          {uint8_t(screen.at(at + 2)), uint8_t(screen.at(at + 1)), uint8_t(screen.at(at))});
    }
  return picture;
}

void write_ppm(const Picture& picture, const std::filesystem::path& file) {
  std::ofstream stream(file, std::ios::binary);
  stream << "P6\n" << picture.size.width << " " << picture.size.height << "\n255\n";
  for (const auto& pixel : picture.pixels) stream.write(reinterpret_cast<const char*>(pixel.data()), 3);
  if (!stream.flush()) throw std::runtime_error("could not write " + file.string());
}

} // namespace unghost
