// Files, whole or not at all: written beside their place and moved there.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unghost {

/// A file that appears with its whole content, or not. Every fault is a Failure(failed) with path and reason.
class NewFile {
public:
  /// Opens a file without a name in the folder of `path`, so that a folder that cannot be written to is known
  /// before the work, and nothing stays behind whatever ends the process; with a passing name where the file
  /// system knows no other. What is there and no regular file (a device, a pipe) is written to directly.
  explicit NewFile(std::filesystem::path path);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;

  void write(std::span<const uint8_t> bytes);
  /// Moves the file to its place.
  void commit();

private:
  [[noreturn]] void fail(int error) const;

  std::filesystem::path path_, passing_name_; // the second is empty where nothing of that name is there
  int descriptor_ = -1;
  bool nameless_ = false;
};

/// NAME-1.EXTENSION, or the first after it that is not there.
std::filesystem::path free_name(const std::string& name, const std::string& extension);
void write_file(const std::filesystem::path& path, std::span<const uint8_t> bytes);
std::span<const uint8_t> bytes_of(const std::string& text);
/// Throws Failure(failed) where a file of some size could not be written there now.
void check_takes_files(const std::filesystem::path& folder);
/// Makes the folder where it is not there. Throws Failure(failed).
void make_folder(const std::filesystem::path& folder);
/// Throws Failure(input_refused) where it cannot be read, is no regular file, or has more than `limit` bytes.
std::vector<uint8_t> read_file(const std::filesystem::path& path, size_t limit);

} // namespace unghost
