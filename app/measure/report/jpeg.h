// Pictures small enough to stand inside a page.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/scene/scene.h"

namespace unghost {

/// sRGB without alpha, colours at full resolution (4:4:4). The same bytes for the same picture.
std::vector<uint8_t> encode_jpeg(const Image& picture, int quality = 82);

} // namespace unghost
