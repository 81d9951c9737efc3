// Files from disk, bounded: the scene file itself, and what lies in its folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "renderer/scene/load.h"

namespace unghost::gltf {

/// A file that is missing, cannot be read, is no regular file or is too large.
struct FileProblem : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The folder of a scene, as the only place files come from.
class Folder {
public:
  enum class Confine { by_kernel, by_path }; // openat2, or canonical paths where the kernel has none

  Folder(const std::filesystem::path& folder, const LoadLimits& limits, Confine confine = Confine::by_kernel);
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  /// Throws FileProblem, and Refused with `pointer` where a link leads out of the folder.
  std::vector<uint8_t> read(const std::string& path, const std::string& pointer);
  /// What was asked for.
  const std::vector<std::filesystem::path>& files() const { return files_; }

private:
  int open_beneath(const std::string& path, const std::string& pointer) const;
  int open_by_path(const std::string& path, const std::string& pointer) const;

  std::filesystem::path folder_;
  int descriptor_ = -1;
  uint64_t file_bytes_, bytes_left_;
  Confine confine_;
  std::vector<std::filesystem::path> files_;
};

/// Reads a regular file of at most `limit` bytes; never waits on a FIFO or a device. Throws FileProblem.
std::vector<uint8_t> read_file(const std::filesystem::path& path, uint64_t limit);

} // namespace unghost::gltf
