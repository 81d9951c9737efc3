// A program that runs beside a test, which reads its standard output line by line.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "tests/app/child.h"

namespace unghost {

using Words = std::vector<std::string>;
using Milliseconds = std::chrono::milliseconds;

/// Far more than anything takes, on a slow machine and sanitized, too: only what fails takes it.
inline constexpr Milliseconds patience{30'000};

class Process {
public:
  /// The first word is found by PATH; what it says on standard error goes to the file `talk`. It ends when
  /// the test does, however that ends.
  Process(const Words& words, const std::filesystem::path& talk);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// The next line without its end; nothing where none came in time, or the output is at its end.
  std::optional<std::string> line(Milliseconds limit = patience);
  /// Everything until the end of the output.
  std::string rest();
  /// The exit code, 128 + the signal where one ended it; nothing where it still runs after that time.
  std::optional<int> exit_code(Milliseconds limit = patience);
  void signal(int number) const;
  /// How large files may get that it writes from now on; nothing: as large as they want.
  void limit_files(std::optional<uint64_t> bytes) const;
  std::string talk() const { return content_of(talk_); }

private:
  bool read_more(std::chrono::steady_clock::time_point until);

  std::filesystem::path talk_;
  std::string unread_;
  std::optional<int> exit_code_;
  int output_ = -1;
  pid_t child_ = -1;
};

} // namespace unghost
