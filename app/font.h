// A bitmap font for labels on pictures.
#pragma once

#include <cstdint>

namespace unghost {

constexpr uint32_t glyph_width = 6, glyph_height = 8; // with the gap to the next letter

/// Whether pixel (x, y) of a letter is set, from the top left; letters beyond ASCII look like `?`.
bool font_pixel(char letter, uint32_t x, uint32_t y);

} // namespace unghost
