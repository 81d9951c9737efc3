// Where the program's data is: beside it, else in share/.
#pragma once

#include <filesystem>
#include <string_view>

namespace unghost {

struct DataFolders {
  std::filesystem::path assets, shaders;
};

/// Throws Failure(failed) naming the places looked at.
DataFolders find_data_folders();
/// A scene that ships with the program (`asphalt`), or a file of the person's.
std::filesystem::path scene_file(std::string_view word, const std::filesystem::path& assets);

} // namespace unghost
