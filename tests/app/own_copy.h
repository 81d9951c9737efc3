// A copy of the program with shaders of a test's own.
#pragma once

#include <filesystem>

namespace unghost {

inline std::filesystem::path folder_of_this_program() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path();
}

/// Puts the program beside the `shaders` in that folder, where it looks for them. Returns its path.
inline std::filesystem::path copy_program(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const fs::path from = folder_of_this_program(), program = folder / "unghost";
  fs::create_symlink(from / "assets", folder / "assets");
  // data is looked for beside the file that runs, and a symbolic link would be followed
  std::error_code across_devices;
  fs::create_hard_link(from / "unghost", program, across_devices);
  if (across_devices) fs::copy_file(from / "unghost", program);
  return program;
}

} // namespace unghost
