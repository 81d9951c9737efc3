#include "assets/generator/textures.h"

#include <algorithm>
#include <cmath>

#include "assets/generator/curve.h"
#include "assets/generator/noise.h"
#include "assets/generator/picture.h"

namespace unghost::author {

using glm::dvec2, glm::dvec3, glm::dvec4;

namespace {

// Asphalt at a point of its tile: dark binder, and stones of three sizes that stick out of it.
struct Asphalt {
  double albedo, height; // linear; metres
  int tint;
};

// Stones and binder gather in patches of a hand's to a foot's size. Without them a distant pixel, which
// covers many stones, would see their average, and the road would turn a flat grey just where the picture
// wants contrast.
double clumps(dvec2 p) {
  return 0.30 * tiled_noise(p, 11, 1) + 0.42 * tiled_noise(p, 29, 2) + 0.62 * tiled_noise(p, 61, 3) +
         0.62 * tiled_noise(p, 127, 4);
}

double stone_albedo(uint32_t id) {
  const double pick = random_unit(id, 11), vary = 0.75 + 0.5 * random_unit(id, 12);
  const double kind = pick < 0.34 ? 0.075 : pick < 0.66 ? 0.17 : pick < 0.90 ? 0.36 : 0.62;
  return kind * vary;
}

Asphalt asphalt(dvec2 p) {
  const double clump = clumps(p);
  Asphalt a{0.030 * (1 + 0.4 * tiled_noise(p, 400, 5)), 0.0004 * clump, 0};
  // From the smallest to the largest: a large stone covers small ones.
  for (const int cells : {430, 290, 190}) {
    const NearestPoint stone = tiled_cells(p, cells, uint32_t(cells));
    const double size = asphalt_tile / cells;
    const double radius = 0.30 + 0.26 * random_unit(stone.id, 21);
    const double presence = random_unit(stone.id, 22);
    if (presence > (cells == 190 ? 0.42 : 0.62) + 0.30 * clump) continue;
    const double cover =
        smooth_step(radius + 0.10, radius - 0.10, stone.distance) * smooth_step(0.0, 0.10, stone.border);
    if (cover <= 0) continue;
    a.albedo = glm::mix(a.albedo, stone_albedo(stone.id), cover);
    a.height += cover * size * 0.16;
    if (cover > 0.5) a.tint = int(3 * random_unit(stone.id, 23));
  }
  a.albedo = std::clamp(a.albedo * std::exp(0.80 * clump), 0.018, 0.72);
  return a;
}

} // namespace

std::vector<uint8_t> asphalt_colour_png() {
  const Picture picture(1024, [](dvec2 p) {
    const Asphalt a = asphalt(p);
    return dvec4(a.albedo, a.tint, 0, 1);
  });
  return palette_png(picture, 36, {{1.0, 1.0, 1.0}, {1.0, 0.95, 0.88}, {0.93, 0.97, 1.0}});
}

std::vector<uint8_t> asphalt_normal_png() {
  const Picture relief(512, [](dvec2 p) { return dvec4(asphalt(p).height, 0, 0, 1); });
  return normal_png(relief, asphalt_tile, 10);
}

std::vector<uint8_t> road_paint_png() {
  const Picture picture(512, [](dvec2 p) {
    const Asphalt a = asphalt(p);
    const double wear =
        0.5 * tiled_noise(p, 9, 31) + 0.5 * tiled_noise(p, 47, 32) + 0.6 * tiled_noise(p, 170, 33);
    const double paint = smooth_step(-0.75, -0.45, wear + 300 * (a.height - 0.001));
    return dvec4(glm::mix(a.albedo, 0.66 + 0.10 * tiled_noise(p, 210, 34), paint), 0, 0, 1);
  });
  return palette_png(picture, 28, {{1.0, 0.99, 0.95}});
}

std::vector<uint8_t> grass_png() {
  const Picture picture(512, [](dvec2 p) {
    const double patches = 0.5 * tiled_noise(p, 7, 41) + 0.4 * tiled_noise(p, 19, 42);
    // Blades: noise stretched along a direction that wanders.
    const dvec2 bent = p + 0.012 * dvec2(tiled_noise(p, 31, 43), tiled_noise(p, 37, 44));
    const double blades = 0.5 * tiled_noise(bent, 120, 45) + 0.7 * tiled_noise(bent, 230, 46);
    const double grey = 0.30 * std::exp(0.50 * patches + 0.75 * blades);
    const int tint = patches + 0.4 * blades > 0.28 ? 2 : blades > 0.15 ? 1 : 0;
    return dvec4(std::clamp(grey, 0.05, 0.95), tint, 0, 1);
  });
  return palette_png(picture, 24, {{0.30, 0.50, 0.11}, {0.40, 0.58, 0.13}, {0.58, 0.60, 0.20}});
}

std::vector<uint8_t> leaves_png() {
  struct Leaf {
    dvec2 centre, along;
    double length, shade;
  };
  std::vector<Leaf> leaves;
  for (uint32_t i = 0; i < 110; ++i) {
    const double angle = 6.2831853 * random_unit(i, 51), out = 0.43 * std::sqrt(random_unit(i, 52));
    const double turn = angle + 2.2 * (random_unit(i, 53) - 0.5);
    leaves.push_back({dvec2(0.5) + out * dvec2(std::cos(angle), std::sin(angle)),
                      {std::cos(turn), std::sin(turn)},
                      0.045 + 0.03 * random_unit(i, 54),
                      0.55 + 0.9 * random_unit(i, 55)});
  }
  const Picture picture(256, [&](dvec2 p) {
    dvec4 colour(0.045, 0.095, 0.016, 0); // under the leaves: what mipmaps bleed in at their edges
    for (const Leaf& leaf : leaves) {
      const dvec2 d = p - leaf.centre;
      const double u = glm::dot(d, leaf.along) / leaf.length;
      const double v = (d.y * leaf.along.x - d.x * leaf.along.y) / leaf.length;
      const double inside = (1 - u * u) * 0.48 - std::abs(v);
      const double alpha = std::clamp(0.5 + inside * leaf.length * 256, 0.0, 1.0);
      if (std::abs(u) > 1 || alpha <= 0) continue;
      const double rib = 0.8 + 0.4 * smooth_step(0.0, 0.18, std::abs(v));
      const dvec3 leaf_colour = leaf.shade * rib * dvec3(0.070, 0.150, 0.022);
      colour = dvec4(glm::mix(dvec3(colour), leaf_colour, alpha), std::max(colour.w, alpha));
    }
    return colour;
  });
  return colour_png(picture);
}

} // namespace unghost::author
