#include "assets/generator/picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <png.h>

namespace unghost::author {

using glm::dvec2, glm::dvec3, glm::dvec4;

namespace {

double to_srgb(double linear) {
  linear = std::clamp(linear, 0.0, 1.0);
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

uint8_t byte(double unit) { return uint8_t(std::clamp(unit, 0.0, 1.0) * 255 + 0.5); }

void append_bytes(png_structp png, png_bytep data, png_size_t size) {
  auto* out = static_cast<std::vector<uint8_t>*>(png_get_io_ptr(png));
  out->insert(out->end(), data, data + size);
}

void fail(png_structp, png_const_charp why) { throw std::runtime_error(why); }

std::vector<uint8_t> encoded(int side, int colour_type, const std::vector<uint8_t>& bytes, int filters,
                             const std::vector<png_color>& palette = {}) {
  std::vector<uint8_t> out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &out, append_bytes, nullptr);
  png_set_compression_level(png, 9);
  png_set_filter(png, 0, filters);
  const auto size = png_uint_32(side);
  png_set_IHDR(png, info, size, size, 8, colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), int(palette.size()));
  png_write_info(png, info);
  const size_t stride = bytes.size() / size_t(side);
  for (size_t row = 0; row < size_t(side); ++row) png_write_row(png, bytes.data() + row * stride);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

} // namespace

Picture::Picture(int side_, const std::function<dvec4(dvec2)>& paint) : side(side_) {
  texels.reserve(size_t(side) * size_t(side));
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) texels.push_back(paint(dvec2(x + 0.5, y + 0.5) / double(side)));
}

const dvec4& Picture::at_wrapped(int x, int y) const {
  return texels[size_t((y + side) % side) * size_t(side) + size_t((x + side) % side)];
}

std::vector<uint8_t> palette_png(const Picture& picture, int levels, const std::vector<dvec3>& tints) {
  std::vector<png_color> palette;
  for (const dvec3 tint : tints) {
    for (int level = 0; level < levels; ++level) {
      // Levels are even in sRGB, where equal steps look about equal.
      const double grey = double(level) / (levels - 1);
      const dvec3 c = glm::pow(tint, dvec3(1 / 2.2)) * grey;
      palette.push_back({byte(c.x), byte(c.y), byte(c.z)});
    }
  }
  std::vector<uint8_t> indices;
  for (const dvec4& texel : picture.texels) {
    const int level = int(to_srgb(texel.x) * (levels - 1) + 0.5);
    indices.push_back(uint8_t(int(texel.y) * levels + level));
  }
  return encoded(picture.side, PNG_COLOR_TYPE_PALETTE, indices, PNG_FILTER_NONE, palette);
}

std::vector<uint8_t> colour_png(const Picture& picture) {
  std::vector<uint8_t> bytes;
  for (const dvec4& t : picture.texels)
    bytes.insert(bytes.end(), {byte(to_srgb(t.x)), byte(to_srgb(t.y)), byte(to_srgb(t.z)), byte(t.w)});
  return encoded(picture.side, PNG_COLOR_TYPE_RGBA, bytes, PNG_ALL_FILTERS);
}

std::vector<uint8_t> normal_png(const Picture& relief, double width, int levels) {
  std::vector<uint8_t> bytes;
  const double step = 2 * width / relief.side;
  const auto settled = [&](double component) {
    return byte((std::floor(component * levels + 0.5) / levels) * 0.5 + 0.5);
  };
  for (int y = 0; y < relief.side; ++y) {
    for (int x = 0; x < relief.side; ++x) {
      const double dx = (relief.at_wrapped(x + 1, y).x - relief.at_wrapped(x - 1, y).x) / step;
      const double dy = (relief.at_wrapped(x, y - 1).x - relief.at_wrapped(x, y + 1).x) / step;
      const dvec3 n = glm::normalize(dvec3(-dx, -dy, 1));
      const dvec2 xy(std::floor(n.x * levels + 0.5) / levels, std::floor(n.y * levels + 0.5) / levels);
      const double z = std::sqrt(std::max(0.0, 1 - glm::dot(xy, xy)));
      bytes.insert(bytes.end(), {settled(n.x), settled(n.y), byte(z * 0.5 + 0.5)});
    }
  }
  return encoded(relief.side, PNG_COLOR_TYPE_RGB, bytes, PNG_FILTER_NONE);
}

} // namespace unghost::author
