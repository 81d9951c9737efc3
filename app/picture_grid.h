// Pictures of one size beside one another, each with its name, and enlarged parts below it.
#pragma once

#include <span>
#include <string>

#include "app/difference.h"

namespace unghost {

struct LabelledPicture {
  std::string label;
  Image picture;
};

/// Enlarged parts are drawn at 3 times their size, nearest pixel, side by side, so two of a sixth of the
/// picture's width fill its width; a frame of the same colour marks where each comes from.
constexpr uint32_t crop_share = 6, crop_zoom = 3, crops_a_row = 2;

/// At least one picture; all have the size of the first.
Image picture_grid(std::span<const LabelledPicture> pictures, std::span<const Window> crops);

} // namespace unghost
