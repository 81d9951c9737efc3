// Trees of leaf-cluster cards about a few crowns of one kind each, and copses on the far hills.
#include "assets/generator/track.h"

#include <cmath>

#include "assets/generator/noise.h"

namespace unghost::author {

using glm::dvec2, glm::dvec3, glm::dvec4;

namespace {

struct Kind {
  const char* name;
  double trunk, height, width; // metres: to the crown's foot, the crown's height and width
  int lobes, cards;
  double card; // metres
};

constexpr Kind kinds[] = {{"tree_broad", 2.4, 6.4, 6.4, 9, 165, 1.75},
                          {"tree_tall", 2.0, 9.5, 3.4, 8, 140, 1.55},
                          {"tree_young", 1.5, 4.2, 3.2, 6, 105, 1.20},
                          {"bush", 0.15, 1.5, 2.4, 5, 44, 0.88}};

dvec3 random_direction(uint32_t a, uint32_t b) {
  const double up = 2 * random_unit(a, b, 1) - 1, angle = 2 * Track::pi * random_unit(a, b, 2);
  const double flat = std::sqrt(1 - up * up);
  return {flat * std::cos(angle), up, flat * std::sin(angle)};
}

// A card looks outwards; its normals lean away from the crown's middle, so that the crown is shaded as one
// volume.
void add_card(Triangles& to, dvec3 place, dvec3 out, dvec3 crown_centre, double size, double shade,
              uint32_t seed) {
  const dvec3 facing = glm::normalize(out + 0.9 * random_direction(seed, 91));
  const dvec3 side =
      glm::normalize(glm::cross(std::abs(facing.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), facing));
  const double turn = 2 * Track::pi * random_unit(seed, 92);
  const dvec3 up = glm::cross(facing, side);
  const dvec3 u = size / 2 * (std::cos(turn) * side + std::sin(turn) * up);
  const dvec3 v = size / 2 * (std::cos(turn) * up - std::sin(turn) * side);
  const dvec3 tint = shade * dvec3(0.92 + 0.16 * random_unit(seed, 93), 1.0, 0.95);
  const auto first = uint32_t(to.positions.size());
  for (const dvec2 corner : {dvec2(-1, -1), dvec2(1, -1), dvec2(1, 1), dvec2(-1, 1)}) {
    const dvec3 p = place + corner.x * u + corner.y * v;
    const dvec3 normal = glm::normalize(p - crown_centre) + dvec3(0, 0.35, 0) + 0.4 * facing;
    to.add(p, normal, dvec2(corner.x, -corner.y) * 0.5 + 0.5, dvec4(glm::min(tint, 1.0), 1));
  }
  to.quad(first, first + 1, first + 2, first + 3);
}

Triangles crown(const Kind& kind, uint32_t seed) {
  Triangles t;
  const dvec3 half(kind.width / 2, kind.height / 2, kind.width / 2),
      middle(0, kind.trunk + kind.height / 2, 0);
  for (int i = 0; i < kind.cards; ++i) {
    const auto lobe = uint32_t(i % kind.lobes);
    const dvec3 lobe_out = random_direction(lobe, seed);
    const dvec3 lobe_centre = middle + 0.58 * lobe_out * half;
    const dvec3 out = random_direction(uint32_t(i), seed + 1);
    const double reach = 0.40 * (0.75 + 0.25 * random_unit(uint32_t(i), seed, 3));
    const dvec3 place = lobe_centre + reach * out * half;
    const double height = (place.y - kind.trunk) / kind.height, depth = glm::length((place - middle) / half);
    const double shade = std::min(1.0, 0.30 + 0.40 * height + 0.35 * depth * depth);
    add_card(t, place, glm::normalize(out + 0.6 * lobe_out), middle, kind.card, shade,
             hashed(seed, uint32_t(i)));
  }
  return t;
}

Triangles trunk(const Kind& kind) {
  Triangles t;
  const double thick = 0.05 * kind.width, top = kind.trunk + 0.55 * kind.height;
  add_lathe(t, dvec3(0), {0, 1, 0},
            {{1.7 * thick, -0.3}, {1.1 * thick, 0.35}, {0.9 * thick, kind.trunk}, {0.25 * thick, top}}, 6);
  for (uint32_t i = 0; i < 3; ++i) {
    const double angle = 2.1 * i + 0.4;
    const dvec3 along = glm::normalize(dvec3(std::cos(angle), 1.1, std::sin(angle)));
    add_lathe(t, dvec3(0, kind.trunk + 0.06 * kind.height * i, 0), along,
              {{0.5 * thick, 0}, {0.15 * thick, 0.30 * kind.width}}, 4);
  }
  return t;
}

// A wood's edge seen from a hundred metres: few, large cards.
Triangles copse() {
  Triangles t;
  for (uint32_t i = 0; i < 6; ++i) {
    const double size = 7 + 4 * random_unit(i, 95);
    const Kind kind{"", 0.4, size, 0.85 * size, 5, 28, 0.42 * size};
    const dvec3 place(26 * (random_unit(i, 96) - 0.5), 0, 12 * (random_unit(i, 97) - 0.5));
    t.append(transformed(crown(kind, 200 + i), glm::dmat3(1.0), place));
  }
  return t;
}

void plant(Glb& glb, const std::string& name, int mesh, double along, double left, double scale,
           double turned) {
  Placement place = on_track(along, left, 0, turned);
  place.translation.y = ground_height(place.translation) - 0.05;
  place.scale = dvec3(scale);
  glb.add_node(name, -1, place, {{"mesh", mesh}});
}

} // namespace

void add_trees(Glb& glb, const WorldMaterials& m) {
  int meshes[4];
  for (uint32_t kind = 0; kind < 4; ++kind)
    meshes[kind] = glb.add_mesh(kinds[kind].name,
                                {{m.leaves, crown(kinds[kind], 100 + kind)}, {m.bark, trunk(kinds[kind])}});
  for (uint32_t i = 0; i < 128; ++i) {
    const auto pick = [&](uint32_t what) { return random_unit(i, what, 77); };
    const bool outside = i % 8 < 6, bush = i % 4 == 3;
    const double along = -45 + 520.0 * (i + pick(1)) / 128;
    const double left =
        outside ? (bush ? -8.0 - 5 * pick(2) : -10.5 - 34 * pick(2) * pick(3)) : 17 + 40 * pick(2) * pick(3);
    const int kind = bush ? 3 : int(3 * pick(4));
    plant(glb, "tree_" + std::to_string(i), meshes[kind], along, left, 0.8 + 0.5 * pick(5), 6.28 * pick(6));
  }
  const int wood = glb.add_mesh("copse", {{m.leaves, copse()}});
  for (uint32_t i = 0; i < 48; ++i)
    plant(glb, "copse_" + std::to_string(i), wood, Track::length * (i + 0.8 * random_unit(i, 98)) / 48,
          -62 - 110 * random_unit(i, 99), 0.9 + 0.7 * random_unit(i, 100), random_unit(i, 101) - 0.5);
}

} // namespace unghost::author
