// What a glTF document may point at: data inside itself, or a file beside it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unghost::gltf {

bool is_data_uri(std::string_view uri);

/// The bytes of `data:...,...` with base64 or percent-encoding; nothing where it is malformed.
std::optional<std::vector<uint8_t>> decode_data_uri(std::string_view uri);

/// The relative path that a URI means, percent-decoded once. Throws Refused, with `pointer`, for a scheme, an
/// absolute path, a backslash, a NUL, and a path that leaves the folder.
std::string path_of_uri(std::string_view uri, const std::string& pointer);

} // namespace unghost::gltf
