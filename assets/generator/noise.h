// Noise that repeats without a seam, from a hash of integers: the same on every machine.
#pragma once

#include <cstdint>

#include <glm/glm.hpp>

namespace unghost::author {

/// PCG's output permutation, chained over the three words (Jarzynski and Olano 2020).
uint32_t hashed(uint32_t a, uint32_t b = 0, uint32_t c = 0);

/// In [0, 1).
double random_unit(uint32_t a, uint32_t b = 0, uint32_t c = 0);

/// Smooth value noise in [-1, 1] over the torus: `p` in [0, 1)^2 holds `cells` x `cells` lattice points.
double tiled_noise(glm::dvec2 p, int cells, uint32_t seed);

/// What is nearest to `p` among one random point a cell.
struct NearestPoint {
  double distance; // in cells
  double border;   // how much further away the second nearest is
  uint32_t id;     // of the point
};
NearestPoint tiled_cells(glm::dvec2 p, int cells, uint32_t seed);

} // namespace unghost::author
