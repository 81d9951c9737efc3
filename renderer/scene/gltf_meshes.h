// Meshes as triangle lists with complete vertices.
#pragma once

#include "renderer/scene/gltf_accessors.h"
#include "renderer/scene/gltf_model.h"
#include "renderer/scene/scene.h"

namespace unghost::gltf {

/// Fills vertices, indices and meshes of a scene whose materials are there (the last one being the default):
/// one mesh for each of the model. Throws Refused.
void read_meshes(Scene& scene, const tinygltf::Model& model, const Accessors& accessors,
                 const LoadLimits& limits, Warnings& warnings);

} // namespace unghost::gltf
