// Materials, with their textures resolved to images and samplers.
#pragma once

#include "renderer/scene/gltf_images.h"
#include "renderer/scene/gltf_model.h"

namespace unghost::gltf {

/// One for each material of the model, in its order, and the default one behind them: at least one.
std::vector<Material> read_materials(const tinygltf::Model& model, Images& images, Warnings& warnings);

} // namespace unghost::gltf
