#include "app/label.h"

#include <algorithm>

#include "app/font.h"

namespace unghost {
namespace {

constexpr uint32_t margin = 3; // times the scale

void darken(Image& picture, const LabelRoom& room) {
  for (uint32_t y = room.y; y < std::min(room.y + room.height, picture.height); ++y)
    for (uint32_t x = room.x; x < std::min(room.x + room.width, picture.width); ++x)
      for (uint32_t c = 0; c < 3; ++c) picture.rgba[(size_t(y) * picture.width + x) * 4 + c] /= 5;
}

void draw_letter(Image& picture, char letter, uint32_t left, uint32_t top, uint32_t scale) {
  for (uint32_t y = 0; y < glyph_height * scale; ++y)
    for (uint32_t x = 0; x < glyph_width * scale; ++x) {
      if (!font_pixel(letter, x / scale, y / scale)) continue;
      if (left + x >= picture.width || top + y >= picture.height) continue;
      for (uint32_t c = 0; c < 3; ++c)
        picture.rgba[(size_t(top + y) * picture.width + left + x) * 4 + c] = 255;
    }
}

} // namespace

uint32_t label_scale(uint32_t picture_height) { return std::max(1u, picture_height / 270); }

uint32_t label_width(const std::string& label, uint32_t scale) {
  return (uint32_t(label.size()) * glyph_width + 2 * margin) * scale;
}

void draw_label(Image& picture, const std::string& label, const LabelRoom& room, uint32_t scale) {
  const uint32_t letters = std::min(uint32_t(label.size()), room.width / (glyph_width * scale));
  darken(picture, {.x = room.x,
                   .y = room.y,
                   .width = std::min((letters * glyph_width + 2 * margin) * scale, room.width),
                   .height = std::min((glyph_height + 2 * margin) * scale, room.height)});
  for (uint32_t i = 0; i < letters; ++i)
    draw_letter(picture, label[i], room.x + (margin + i * glyph_width) * scale, room.y + margin * scale,
                scale);
}

} // namespace unghost
