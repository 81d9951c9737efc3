// The JSON of a glTF file: bounded before it is parsed, and of a version and with extensions that we know.
#pragma once

#include <string_view>

#include <nlohmann/json.hpp>

#include "renderer/scene/gltf_report.h"
#include "renderer/scene/load.h"

namespace unghost::gltf {

using Json = nlohmann::json;

/// Depth and number of values are counted over the bytes first, so that no parser recurses or allocates for
/// them. Throws Refused, also for another version than 2.x and for an extension that is required and not
/// drawn.
Json parse_json(std::string_view text, const LoadLimits& limits, Warnings& warnings);

} // namespace unghost::gltf
