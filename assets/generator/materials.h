// Every material of the scene, by name.
#pragma once

#include "assets/generator/glb.h"

namespace unghost::author {

struct CarMaterials {
  int paint, glass, chrome, gloss_black, plastic, rubber, alloy, steel, caliper, lamp, tail_lamp, indicator,
      plate;
};

struct WorldMaterials {
  int asphalt, road_paint, tar, gravel, grass, kerb_red, kerb_white, galvanised, post, dark, reflector,
      rubber, leaves, bark;
};

CarMaterials add_car_materials(Glb& glb);
WorldMaterials add_world_materials(Glb& glb);

} // namespace unghost::author
