#include "app/measure/magma.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>

namespace unghost {
namespace {

/// A fit of sixth degree by Matt Zucker (2019, CC0); off by at most 4 of 255.
glm::dvec3 magma_at(double t) {
  constexpr glm::dvec3 c0(-0.002136485053939582, -0.000749655052795221, -0.005386127855323933),
      c1(0.2516605407371642, 0.6775232436837668, 2.494026599312351),
      c2(8.353717279216625, -3.577719514958484, 0.3144679030132573),
      c3(-27.66873308576866, 14.26473078096533, -13.64921318813922),
      c4(52.17613981234068, -27.94360607168351, 12.94416944238394),
      c5(-50.76852536473588, 29.04658282127291, 4.23415299384598),
      c6(18.65570506591883, -11.48977351997711, -5.601961508734096);
  return c0 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * (c5 + t * c6)))));
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
