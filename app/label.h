// Names on pictures.
#pragma once

#include <cstdint>
#include <string>

#include "renderer/scene/scene.h"

namespace unghost {

/// Pixels; a label stays within.
struct LabelRoom {
  uint32_t x = 0, y = 0, width = 0, height = 0;
};

/// How many times as large as the font a label reads well in a picture of that height.
uint32_t label_scale(uint32_t picture_height);
uint32_t label_width(const std::string& label, uint32_t scale);
/// White on a darkened ground in the room's top left corner, cut at its right edge.
void draw_label(Image& picture, const std::string& label, const LabelRoom& room, uint32_t scale);

} // namespace unghost
