// What is bolted to the car's body: mirrors, handles, lamps, grille bars, exhausts, plates, wipers.
#pragma once

#include <vector>

#include "assets/generator/glb.h"
#include "assets/generator/materials.h"

namespace unghost::author {

std::vector<Part> car_fittings(const CarMaterials& materials);

} // namespace unghost::author
