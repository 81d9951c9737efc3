#include "app/measure/magma.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

#include "shaders/shared/magma.h"

namespace unghost {
namespace {

glm::dvec3 magma_at(double t) {
  glm::dvec3 colour(0);
#define MAGMA_TERM(red, green, blue) colour = glm::dvec3(red, green, blue) + t * colour;
  MAGMA_TERMS(MAGMA_TERM)
#undef MAGMA_TERM
  return colour;
}

} // namespace

Image magma(const FloatImage& values) {
  std::vector<uint8_t> colours;
  for (int i = 0; i < 256; ++i)
    for (int channel = 0; channel < 3; ++channel)
      colours.push_back(uint8_t(std::clamp(std::lround(255 * magma_at(i / 255.0)[channel]), 0l, 255l)));
  Image map{.name = {}, .width = values.width, .height = values.height, .rgba = {}};
  map.rgba.reserve(values.values.size() * 4);
  for (const float value : values.values) {
    const auto at = size_t(std::clamp(std::lround(255 * value), 0l, 255l)) * 3;
    map.rgba.insert(map.rgba.end(), {colours[at], colours[at + 1], colours[at + 2], 255});
  }
  return map;
}

} // namespace unghost
