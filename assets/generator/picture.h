// Pictures while they are painted, and as PNG files in memory.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include <glm/glm.hpp>

namespace unghost::author {

/// A square of colours, row by row from the top. Linear until it is encoded.
struct Picture {
  int side;
  std::vector<glm::dvec4> texels;

  /// Painted texel by texel; `paint` gets texel centres in [0, 1)^2.
  Picture(int side, const std::function<glm::dvec4(glm::dvec2)>& paint);
  const glm::dvec4& at_wrapped(int x, int y) const;
};

/// Greys, each multiplied by one of a few tints: noise packs well in few levels. `texels` hold (grey, tint
/// index).
std::vector<uint8_t> palette_png(const Picture& picture, int levels, const std::vector<glm::dvec3>& tints);

/// sRGB with straight alpha.
std::vector<uint8_t> colour_png(const Picture& picture);

/// The tangent-space normals of a relief: texel.x is the height in metres of a tile `width` metres wide.
/// OpenGL's convention, as glTF has it: green points up the picture.
std::vector<uint8_t> normal_png(const Picture& relief, double width, int levels);

} // namespace unghost::author
