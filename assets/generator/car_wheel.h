// A wheel, and what stays still inside it.
#pragma once

#include <vector>

#include "assets/generator/glb.h"
#include "assets/generator/materials.h"

namespace unghost::author {

/// Tyre, rim, spokes and brake disc; the axle is local x, the outer face looks to +x.
std::vector<Part> car_wheel(const CarMaterials& materials);

/// The brake caliper of that wheel, in the same frame; it does not spin. `lead` is +1 or -1: the side of the
/// axle, along z, that it sits on.
std::vector<Part> brake_caliper(const CarMaterials& materials, double lead);

} // namespace unghost::author
