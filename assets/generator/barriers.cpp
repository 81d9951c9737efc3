// Guard rails on posts along both sides, and a wall of tyres where the road tightens to the eye.
#include "assets/generator/track.h"

#include <cmath>

namespace unghost::author {

using glm::dvec2, glm::dvec3;

namespace {

// The pressed steel beam in section: (towards the road, up).
const std::vector<dvec2> beam = {{0.00, 0.44},  {0.055, 0.475}, {0.055, 0.525}, {0.00, 0.565},
                                 {0.00, 0.615}, {0.055, 0.655}, {0.055, 0.705}, {0.00, 0.74}};

// `side` +1: the road is to the left of the rail.
Triangles guard_rail(double left, double side) {
  Triangles t;
  const int rows = 9;
  const double step = Track::sector_length / rows;
  const auto at = [&](int row, dvec2 p) { return sector_point(row * step, left + side * p.x, p.y); };
  for (size_t i = 0; i + 1 < beam.size(); ++i) {
    for (int row = 0; row < rows; ++row) {
      const dvec3 a = at(row, beam[i]), b = at(row + 1, beam[i]), c = at(row + 1, beam[i + 1]),
                  d = at(row, beam[i + 1]);
      side > 0 ? add_flat_quad(t, d, c, b, a) : add_flat_quad(t, a, b, c, d);
    }
  }
  for (int row = 0; row < rows; ++row) { // the back, as good as flat from where it is seen
    const dvec3 a = at(row, beam.front()), b = at(row + 1, beam.front());
    const dvec3 c = at(row + 1, beam.back()), d = at(row, beam.back());
    side > 0 ? add_flat_quad(t, a, b, c, d) : add_flat_quad(t, d, c, b, a);
  }
  return t;
}

Triangles rail_posts(double left, double side) {
  Triangles t;
  const int posts = 9;
  for (int i = 0; i < posts; ++i) {
    const double along = Track::sector_length * (i + 0.5) / posts;
    const glm::dmat3 turn = turn_about({0, 1, 0}, along / Track::radius);
    add_box(t, sector_point(along, left - side * 0.055, 0.30), {0.05, 0.42, 0.035}, turn);
  }
  return t;
}

Triangles tyre_ring(double up, double turn) {
  Triangles t;
  add_lathe(t, dvec3(0, up, 0), turn_about({1, 0, 0}, turn) * dvec3(0, 1, 0),
            {{0.25, -0.1}, {0.32, -0.07}, {0.32, 0.07}, {0.25, 0.1}, {0.17, 0.085, true}, {0.17, -0.1}}, 9);
  return t;
}

void add_tyre_wall(Glb& glb, const WorldMaterials& m) {
  Triangles low = tyre_ring(0.07, 0.0);
  low.append(tyre_ring(0.27, -0.02));
  const Triangles top = tyre_ring(0.47, 0.02);
  const int black = glb.add_mesh("tyre_stack", {{m.rubber, low}, {m.rubber, top}});
  const int white = glb.add_mesh("tyre_stack_painted", {{m.rubber, low}, {m.kerb_white, top}});
  for (int i = 0; i < 28; ++i)
    glb.add_node("tyre_stack_" + std::to_string(i), -1,
                 on_track(72 + 0.66 * i, Track::outer_barrier + 0.55, -0.02, i),
                 {{"mesh", i % 3 == 0 ? white : black}});
}

} // namespace

void add_barriers(Glb& glb, const WorldMaterials& m) {
  const auto mesh = [&](const char* name, double left, double side) {
    return glb.add_mesh(name, {{m.galvanised, guard_rail(left, side)}, {m.post, rail_posts(left, side)}});
  };
  const int outer = mesh("barrier_outer", Track::outer_barrier, 1),
            inner = mesh("barrier_inner", Track::inner_barrier, -1);
  for (int sector = 0; sector < Track::sectors; ++sector) {
    const std::string number = std::to_string(sector);
    glb.add_node("barrier_outer_" + number, -1, sector_placement(sector), {{"mesh", outer}});
    glb.add_node("barrier_inner_" + number, -1, sector_placement(sector), {{"mesh", inner}});
  }
  add_tyre_wall(glb, m);
}

} // namespace unghost::author
