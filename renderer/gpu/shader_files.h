// The compiled shaders of a folder, known by the sums they were built with.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace unghost {

/// As sha256sum writes it; it is made after all that it names.
inline constexpr const char* list_of_sums = "sums.txt";

class ShaderFiles {
public:
  explicit ShaderFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& folder() const { return folder_; }
  /// Read when it is first asked for, and kept. `file` without .spv. Throws std::runtime_error for what is
  /// missing or is not what was built.
  const std::vector<uint32_t>& spirv(const std::string& file);
  /// Everything that was built: from then on nothing is read, and a folder that changes does not matter.
  /// Throws as `spirv` does.
  void read_all();

private:
  std::filesystem::path folder_;
  std::map<std::string, std::string> sums_; // of the files of shaders, as they were built
  std::map<std::string, std::vector<uint32_t>> spirv_;
};

} // namespace unghost
