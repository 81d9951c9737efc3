#include "assets/generator/noise.h"

#include <cmath>

namespace unghost::author {

using glm::dvec2;

namespace {

uint32_t pcg(uint32_t value) {
  const uint32_t state = value * 747796405u + 2891336453u;
  const uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

uint32_t wrapped(int i, int cells) { return uint32_t(((i % cells) + cells) % cells); }

} // namespace

uint32_t hashed(uint32_t a, uint32_t b, uint32_t c) { return pcg(pcg(pcg(a) + b) + c); }

double random_unit(uint32_t a, uint32_t b, uint32_t c) { return hashed(a, b, c) / 4294967296.0; }

double tiled_noise(dvec2 p, int cells, uint32_t seed) {
  const dvec2 q = p * double(cells), base = glm::floor(q), f = q - base;
  const auto at = [&](int x, int y) {
    return random_unit(wrapped(int(base.x) + x, cells), wrapped(int(base.y) + y, cells), seed) * 2 - 1;
  };
  const dvec2 t = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
  return glm::mix(glm::mix(at(0, 0), at(1, 0), t.x), glm::mix(at(0, 1), at(1, 1), t.x), t.y);
}

NearestPoint tiled_cells(dvec2 p, int cells, uint32_t seed) {
  const dvec2 q = p * double(cells), base = glm::floor(q);
  double first = 9, second = 9;
  uint32_t id = 0;
  for (int y = -1; y <= 1; ++y) {
    for (int x = -1; x <= 1; ++x) {
      const uint32_t cx = wrapped(int(base.x) + x, cells), cy = wrapped(int(base.y) + y, cells);
      const dvec2 point =
          base + dvec2(x, y) + dvec2(random_unit(cx, cy, seed), random_unit(cx, cy, seed + 1));
      const double distance = glm::length(point - q);
      if (distance < first) {
        second = first;
        first = distance;
        id = hashed(cx, cy, seed + 2);
      } else if (distance < second) {
        second = distance;
      }
    }
  }
  return {first, second - first, id};
}

} // namespace unghost::author
