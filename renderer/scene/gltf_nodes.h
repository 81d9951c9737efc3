// The node graph, in an order where parents come before their children.
#pragma once

#include <vector>

#include "renderer/scene/gltf_model.h"
#include "renderer/scene/load.h"
#include "renderer/scene/scene.h"

namespace unghost::gltf {

/// Fills the nodes of the default scene (without scenes: of all roots), with what their extras say, the
/// vehicle and the track. Returns for each node of the model where it stands in the scene; -1: not part of
/// it. Throws Refused where the graph is no forest.
std::vector<int> read_nodes(Scene& scene, const tinygltf::Model& model, const LoadLimits& limits,
                            Warnings& warnings);

} // namespace unghost::gltf
