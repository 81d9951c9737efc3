// The car's bodywork: the panels cut out of the body, and what is fitted to them.
#pragma once

#include <vector>

#include "assets/generator/glb.h"
#include "assets/generator/materials.h"

namespace unghost::author {

std::vector<Part> car_body(const CarMaterials& materials);

} // namespace unghost::author
