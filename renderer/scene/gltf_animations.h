// Key frames of nodes.
#pragma once

#include "renderer/scene/gltf_accessors.h"
#include "renderer/scene/gltf_model.h"
#include "renderer/scene/scene.h"

namespace unghost::gltf {

/// `places` says where a node of the model stands in the scene (-1: nowhere), as read_nodes returns it.
/// Animations that move nothing in the scene are left out. Throws Refused.
std::vector<Animation> read_animations(const Scene& scene, const tinygltf::Model& model,
                                       const Accessors& accessors, const std::vector<int>& places,
                                       Warnings& warnings);

} // namespace unghost::gltf
