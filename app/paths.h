// Where the program's data is: beside it, else in share/.
#pragma once

#include <filesystem>
#include <string_view>

namespace unghost {

/// The scene of our own: what is drawn where none is named, and the road under a model.
constexpr const char* own_scene = "asphalt";

struct DataFolders {
  std::filesystem::path assets, shaders;
};

/// Throws Failure(failed) naming the places looked at.
DataFolders find_data_folders();
/// A scene that ships with the program (`own_scene`), or a file of the person's.
std::filesystem::path scene_file(std::string_view word, const std::filesystem::path& assets);

} // namespace unghost
