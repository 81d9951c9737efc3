// The car as nodes: what a rig moves, spins and steers, by the names and extras that the loader reads.
#pragma once

#include "assets/generator/glb.h"

namespace unghost::author {

/// The root's node index; the car stands on y = 0 at the origin and looks to +z.
int add_car(Glb& glb);

} // namespace unghost::author
