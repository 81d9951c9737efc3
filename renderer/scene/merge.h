// Scenes put together and taken apart: another model on our asphalt in place of our car.
#pragma once

#include "renderer/scene/scene.h"

namespace unghost {

/// Adds all of `from` to `into`, its roots as children of `parent_node` (-1: as roots), and returns where the
/// first of its nodes now stands: node i of `from` is that plus i. A node without a tag inherits its new
/// parent's. Where `into` has a vehicle or a track, it keeps that one.
int append(Scene& into, const Scene& from, int parent_node);

/// `scene` without `node` and all below it, and without the meshes, vertices, materials, images and tracks
/// that nothing uses any more.
Scene without(const Scene& scene, int node);

} // namespace unghost
