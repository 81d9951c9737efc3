// What unghost reads from glTF's free-form `extras`. A wrong type there is a warning, never a refusal.
#pragma once

#include <optional>

#include "renderer/scene/gltf_model.h"
#include "renderer/scene/scene.h"

namespace unghost::gltf {

/// Sets the node's tag (1 to 255) and wheel; true where the node says it is the vehicle.
bool read_extras(Node& node, const tinygltf::Value& extras, Warnings& warnings);

std::optional<Track> track_of(const tinygltf::Value& extras, Warnings& warnings);

} // namespace unghost::gltf
