// Pictures of one colour.
#pragma once

#include "renderer/scene/scene.h"

namespace unghost {

inline Image picture_of(uint32_t width, uint32_t height, glm::u8vec3 colour) {
  Image picture{.name = {}, .width = width, .height = height, .rgba = {}};
  for (size_t i = 0; i < size_t(width) * height; ++i)
    picture.rgba.insert(picture.rgba.end(), {colour.x, colour.y, colour.z, 255});
  return picture;
}

} // namespace unghost
