// Cameras and lights.
#pragma once

#include "renderer/scene/gltf_model.h"
#include "renderer/scene/scene.h"

namespace unghost::gltf {

/// One camera for each of the model; an orthographic one becomes a perspective one with a warning.
std::vector<Camera> read_cameras(const tinygltf::Model& model, Warnings& warnings);

/// One light for each of the model (KHR_lights_punctual); one of an unknown type has intensity 0.
std::vector<Light> read_lights(const tinygltf::Model& model, Warnings& warnings);

} // namespace unghost::gltf
