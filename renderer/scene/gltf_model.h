// The structure of a checked document, read by tinygltf.
#pragma once

#include <tiny_gltf.h>

#include "renderer/scene/gltf_json.h"

namespace unghost::gltf {

/// Nodes, meshes, materials, textures, animations, cameras and lights of a document that passed check_schema.
/// Buffers, views, accessors and images are not in it: those are read by Accessors and Images, and tinygltf
/// is given placeholders, so that it opens no file, decodes nothing and computes no extent. Throws Refused.
tinygltf::Model read_model(const Json& checked);

} // namespace unghost::gltf
