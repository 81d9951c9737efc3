// The circuit's measures, and where a point of it lies. A place is (along, left): metres of arc from the
// origin on the path that the car drives, and metres to the left of it (negative: right).
#pragma once

#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "assets/generator/glb.h"
#include "assets/generator/materials.h"

namespace unghost::author {

struct Track {
  static constexpr double radius = 150;
  static constexpr int sectors = 35; // each holds three periods of the dashed line
  static constexpr int rows = 18;    // of the road in a sector: a dash is two of them, a gap four
  static constexpr double pi = 3.14159265358979323846;
  static constexpr double length = 2 * pi * radius;
  static constexpr double sector_length = length / sectors;
  static constexpr double right_edge = -2.2, left_edge = 5.8;
  static constexpr double outer_barrier = -6.0, inner_barrier = 11.0;
};

glm::dvec3 track_point(double along, double left, double up = 0);

/// Local +z along the road, +x to the left.
Placement on_track(double along, double left, double up = 0, double turned = 0);

/// A sector's mesh is authored at the origin's end of the road, about the circle's centre, and turned into
/// place.
glm::dvec3 sector_point(double along, double left, double up = 0);
Placement sector_placement(int sector);

/// The height of the ground beyond the road's shoulders.
double ground_height(glm::dvec3 place);

void add_road(Glb& glb, const WorldMaterials& materials);
void add_terrain(Glb& glb, const WorldMaterials& materials);
void add_barriers(Glb& glb, const WorldMaterials& materials);
void add_roadside(Glb& glb, const WorldMaterials& materials);
void add_trees(Glb& glb, const WorldMaterials& materials);

} // namespace unghost::author
