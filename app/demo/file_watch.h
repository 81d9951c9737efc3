// Files that a person changes while the program runs.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace unghost {

/// By their places, so that editors may write into a file or put another one there; twice a second at most.
class FileWatch {
public:
  using Time = std::chrono::steady_clock::time_point;

  FileWatch() = default;
  /// From now on; those that it has already are watched since they were first named.
  void add(const std::vector<std::filesystem::path>& files);
  /// Whether any of them was written, replaced, removed or put back since that was last said. Not before all
  /// have rested from one look to the next, so that nobody reads half a file.
  bool changed(Time now);

private:
  /// All zeros where there is no file.
  struct Stamp {
    uint64_t device = 0, inode = 0, bytes = 0;
    int64_t written_s = 0, written_ns = 0;
    bool operator==(const Stamp&) const = default;
  };
  using Stamps = std::map<std::filesystem::path, Stamp>;
  static Stamp stamp_of(const std::filesystem::path& file);

  Stamps said_, seen_;
  Time next_look_{};
};

} // namespace unghost
