// The road's surface, its lines, kerbs and gravel shoulders. Lines and tar seams are strips of the same
// surface, so that nothing lies on anything.
#include "assets/generator/track.h"

#include <algorithm>
#include <cmath>

#include "assets/generator/curve.h"
#include "assets/generator/noise.h"
#include "assets/generator/textures.h"

namespace unghost::author {

using glm::dvec2, glm::dvec3, glm::dvec4;

namespace {

// A sector ends in a lip below the next one's edge: each is turned into its place, which rounds, and the sky
// would show between them. Flatter than any view of it, or the sky would show between the two from far away.
constexpr double lip_length = 0.4, lip_drop = 0.001;

constexpr int variants = 5; // of the road's wear; they follow each other round the circuit

enum class Surface { asphalt, line, dashes, tar };

/// From one column line to the next.
struct Band {
  Surface surface;
  std::vector<double> columns; // metres to the left
};

// The tar seam wanders; it starts and ends in place, so that sectors meet.
double wander(double left, double t, int variant) {
  if (left < 3.5 || left > 4.2) return left;
  return left + 0.16 * std::sin(2 * Track::pi * t * (1 + variant % 3)) * std::sin(Track::pi * t) +
         0.07 * std::sin(2 * Track::pi * t * 4);
}

const std::vector<Band>& bands() {
  static const std::vector<Band> list = {
      {Surface::asphalt, {-2.2, -2.02}},
      {Surface::line, {-2.02, -1.90}},
      {Surface::asphalt, {-1.90, -1.1, -0.75, -0.4, 0.0, 0.4, 0.75, 1.1, 1.74}},
      {Surface::dashes, {1.74, 1.86}},
      {Surface::asphalt, {1.86, 2.6, 2.93, 3.3, 3.78}},
      {Surface::tar, {3.78, 3.83}},
      {Surface::asphalt, {3.83, 4.1, 4.43, 4.8, 5.5}},
      {Surface::line, {5.50, 5.62}},
      {Surface::asphalt, {5.62, 5.8}},
  };
  return list;
}

// Rubber and oil darken the wheel tracks and the lanes' middles, dust brightens the edges, old and new
// asphalt meet.
dvec4 wear(double along, double left, int variant) {
  double shade = 0.90;
  for (const double lane : {0.0, 3.68}) {
    shade -= 0.24 * (bell(left - lane - 0.75, 0.28) + bell(left - lane + 0.75, 0.28));
    shade -= 0.10 * bell(left - lane, 0.20);
  }
  const dvec2 p(along / Track::sector_length, left / 20 + 0.5);
  shade += 0.09 * tiled_noise(p, 6, 70 + uint32_t(variant)) * std::sin(Track::pi * p.x);
  const double dust = smooth_step(0.55, 0.0, std::min(left - Track::right_edge, Track::left_edge - left));
  const dvec3 colour = glm::mix(dvec3(shade), dvec3(1.0, 0.95, 0.86), dust * 0.8);
  return dvec4(glm::clamp(colour, 0.0, 1.0), 1);
}

// A mended place: its asphalt is newer and darker, and ends at straight edges.
bool mended(int row, double left, int variant) {
  if (variant == 1) return row >= 5 && row < 9 && left > -1.9 && left < 0.2;
  if (variant == 3) return row >= 11 && row < 13 && left > 1.86 && left < 5.5;
  if (variant == 4) return row >= 2 && row < 4 && left > 0.2 && left < 1.74;
  return false;
}

struct RoadParts {
  Triangles asphalt, line, tar;
};

void add_cell(Triangles& to, std::array<double, 2> along, std::array<std::array<double, 2>, 2> left,
              double shade, int variant, double drop = 0) {
  // Lefts are [row][column]; the quad goes round seen from above.
  static constexpr std::array<std::array<int, 2>, 4> round = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  const auto first = uint32_t(to.positions.size());
  for (const auto& [row, column] : round) {
    const double s = along[size_t(row)], l = left[size_t(row)][size_t(column)];
    const dvec4 colour = wear(s, l, variant) * dvec4(dvec3(shade), 1);
    to.add(sector_point(s, l, row == 1 ? -drop : 0), {0, 1, 0}, dvec2(l, s) / asphalt_tile, colour);
  }
  to.quad(first, first + 1, first + 2, first + 3);
}

/// Where every second sector has a tar seam across.
constexpr int seam_row = 14;
constexpr double seam_length = 0.05;

/// Metres along the sector at which all its cells are cut, so that neighbours share their corners.
std::vector<double> cuts_of(bool has_seam) {
  std::vector<double> cuts;
  for (int row = 0; row <= Track::rows; ++row) {
    cuts.push_back(Track::sector_length * row / Track::rows);
    if (has_seam && row == seam_row) cuts.push_back(cuts.back() + seam_length);
  }
  return cuts;
}

RoadParts road_sector(int variant) {
  RoadParts parts;
  const bool has_seam = variant % 2 == 0;
  const std::vector<double> cuts = cuts_of(has_seam);
  const auto left_at = [&](double s, double l) { return wander(l, s / Track::sector_length, variant); };
  for (const Band& band : bands()) {
    for (size_t c = 0; c + 1 < band.columns.size(); ++c) {
      const double low = band.columns[c], high = band.columns[c + 1], middle = 0.5 * (low + high);
      for (size_t cut = 0; cut + 1 < cuts.size(); ++cut) {
        const double from = cuts[cut], until = cuts[cut + 1];
        const int row = int(cut) - (has_seam && int(cut) > seam_row);
        const bool dash = band.surface == Surface::dashes && row % 6 < 2;
        const bool paint = band.surface == Surface::line || dash;
        const bool tar = band.surface == Surface::tar || (has_seam && int(cut) == seam_row);
        Triangles& surface = paint ? parts.line : tar ? parts.tar : parts.asphalt;
        add_cell(surface, {from, until},
                 {{{left_at(from, low), left_at(from, high)}, {left_at(until, low), left_at(until, high)}}},
                 !paint && !tar && mended(row, middle, variant) ? 0.62 : 1, variant);
      }
      const double end = cuts.back(), near = left_at(end, low), far = left_at(end, high);
      add_cell(parts.asphalt, {end, end + lip_length}, {{{near, far}, {near, far}}}, 1, variant, lip_drop);
    }
  }
  parts.tar.colours.clear(); // tar is the same tar everywhere
  return parts;
}

// A strip beside the road: columns of (left, up), from right to left. With a lip, its last row is one.
Triangles strip(const std::vector<dvec2>& columns, double from, double until, int rows, bool lip = false) {
  Triangles t;
  for (size_t c = 0; c + 1 < columns.size(); ++c) {
    const dvec2 low = columns[c], high = columns[c + 1], slope = high - low;
    const auto first = uint32_t(t.positions.size());
    for (int row = 0; row <= rows + lip; ++row) {
      const double drop = row > rows ? lip_drop : 0;
      const double s = row > rows ? until + lip_length : from + (until - from) * row / rows,
                   angle = s / Track::radius;
      const dvec3 left(std::cos(angle), 0, -std::sin(angle));
      for (const dvec2 p : {low, high})
        t.add(sector_point(s, p.x, p.y - drop), dvec3(0, slope.x, 0) - left * slope.y);
    }
    for (uint32_t row = 0; row < uint32_t(rows + lip); ++row) {
      const uint32_t v = first + 2 * row;
      t.quad(v, v + 2, v + 3, v + 1);
    }
  }
  return t;
}

int add_kerb_mesh(Glb& glb, const WorldMaterials& m, const char* name, const std::vector<dvec2>& columns) {
  constexpr int blocks = 26;
  Triangles red, white;
  for (int i = 0; i < blocks; ++i) {
    const double block = Track::sector_length / blocks;
    (i % 2 == 0 ? red : white).append(strip(columns, i * block, (i + 1) * block, 1));
  }
  return glb.add_mesh(name, {{m.kerb_red, red}, {m.kerb_white, white}});
}

} // namespace

void add_road(Glb& glb, const WorldMaterials& m) {
  std::vector<int> surfaces;
  for (int variant = 0; variant < variants; ++variant) {
    RoadParts parts = road_sector(variant);
    surfaces.push_back(
        glb.add_mesh("road_" + std::to_string(variant),
                     {{m.asphalt, parts.asphalt}, {m.road_paint, parts.line}, {m.tar, parts.tar}}));
  }
  Triangles gravel =
      strip({{-3.5, -0.09}, {-2.9, -0.03}, {-2.2, 0}}, 0, Track::sector_length, Track::rows, true);
  gravel.append(strip({{5.8, 0}, {6.5, -0.03}, {7.3, -0.09}}, 0, Track::sector_length, Track::rows, true));
  for (const dvec3 p : gravel.positions) // the asphalt's picture, half as large again
    gravel.uvs.push_back(dvec2(Track::radius - std::hypot(p.x, p.z), Track::radius * std::atan2(p.z, -p.x)) /
                         (asphalt_tile * 1.5));
  const int shoulder = glb.add_mesh("shoulder", {{m.gravel, gravel}});
  const int inner =
      add_kerb_mesh(glb, m, "kerb_inner", {{5.8, 0}, {5.87, 0.025}, {6.15, 0.05}, {6.22, -0.06}});
  const int outer =
      add_kerb_mesh(glb, m, "kerb_outer", {{-2.62, -0.06}, {-2.55, 0.05}, {-2.27, 0.025}, {-2.2, 0}});
  for (int sector = 0; sector < Track::sectors; ++sector) {
    const std::string number = std::to_string(sector);
    const Placement place = sector_placement(sector);
    glb.add_node("road_" + number, -1, place, {{"mesh", surfaces[size_t(sector % variants)]}});
    glb.add_node("shoulder_" + number, -1, place, {{"mesh", shoulder}});
    if (sector % 5 == 0 || sector % 5 == 1)
      glb.add_node("kerb_outer_" + number, -1, place, {{"mesh", outer}});
    if (sector % 7 > 3) glb.add_node("kerb_inner_" + number, -1, place, {{"mesh", inner}});
  }
}

} // namespace unghost::author
