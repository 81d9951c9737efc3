// Grass beside the road, hills around it.
#include "assets/generator/track.h"

#include <cmath>

#include "assets/generator/curve.h"
#include "assets/generator/noise.h"
#include "assets/generator/textures.h"

namespace unghost::author {

using glm::dvec2, glm::dvec3, glm::dvec4;

namespace {

dvec3 ground_normal(dvec3 p) {
  const double e = 0.5;
  const double dx = ground_height(p + dvec3(e, 0, 0)) - ground_height(p - dvec3(e, 0, 0));
  const double dz = ground_height(p + dvec3(0, 0, e)) - ground_height(p - dvec3(0, 0, e));
  return {-dx, 2 * e, -dz};
}

// Meadows and mown verges; far slopes are darker, as woods are.
dvec4 ground_colour(dvec3 p, double left) {
  const dvec2 at = dvec2(p.x, p.z) / 1024.0 + 0.5;
  const double patches = tiled_noise(at, 40, 81) + 0.6 * tiled_noise(at, 130, 82);
  const double far = smooth_step(30, 110, std::abs(left));
  const dvec3 near_colour = dvec3(0.80, 0.80, 0.78) + patches * dvec3(0.13, 0.08, 0.05);
  return dvec4(glm::clamp(glm::mix(near_colour, dvec3(0.42, 0.52, 0.42), far), 0.0, 1.0), 1);
}

// The grass starts under the gravel, deep enough not to show through it.
double grass_height(dvec3 p, double left) {
  const bool under_gravel = left > -3.3 && left < 7.1;
  return under_gravel ? -0.16 : ground_height(p);
}

void add_field(Triangles& to, int sector, const std::vector<double>& lefts) {
  const int rows = 6;
  const auto first = uint32_t(to.positions.size()), across = uint32_t(lefts.size());
  for (int row = 0; row <= rows; ++row) {
    for (const double left : lefts) {
      dvec3 p = track_point(Track::sector_length * (sector + double(row) / rows), left);
      p.y = grass_height(p, left);
      to.add(p, ground_normal(p), dvec2(p.x, p.z) / grass_tile, ground_colour(p, left));
    }
  }
  for (uint32_t row = 0; row < uint32_t(rows); ++row) {
    for (uint32_t c = 0; c + 1 < across; ++c) {
      const uint32_t v = first + row * across + c;
      to.quad(v, v + across, v + across + 1, v + 1);
    }
  }
}

} // namespace

void add_terrain(Glb& glb, const WorldMaterials& m) {
  for (int sector = 0; sector < Track::sectors; ++sector) {
    Triangles outside, inside;
    add_field(outside, sector,
              {-230, -185, -145, -112, -86, -66, -50, -38, -28, -20, -14.5, -10.5, -7.5, -5, -3.45, -3.1});
    add_field(inside, sector, {6.9, 7.25, 9, 12, 16, 22, 30, 42, 58, 78, 100, 125, 147});
    const std::string number = std::to_string(sector);
    glb.add_node("hills_" + number, -1, {},
                 {{"mesh", glb.add_mesh("hills_" + number, {{m.grass, outside}})}});
    glb.add_node("infield_" + number, -1, {},
                 {{"mesh", glb.add_mesh("infield_" + number, {{m.grass, inside}})}});
  }
}

} // namespace unghost::author
