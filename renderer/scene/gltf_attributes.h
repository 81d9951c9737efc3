// The vertices of one primitive, out of its attributes.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "renderer/scene/gltf_accessors.h"
#include "renderer/scene/scene.h"

namespace unghost::gltf {

/// As tinygltf keeps a primitive's attributes: semantic to accessor.
using Attributes = std::map<std::string, int>;

/// Vertices with what the attributes say, normals and tangents of length 1, and defaults for the rest.
/// `quantized` allows the formats of KHR_mesh_quantization. There must be a POSITION. Throws Refused with
/// `pointer`.
std::vector<Vertex> read_vertices(const Attributes& attributes, const Accessors& accessors, bool quantized,
                                  const std::string& pointer);

} // namespace unghost::gltf
