// Another program that works while the window goes on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace unghost {

class BackgroundProcess {
public:
  /// `words` begin with the program's path; no shell reads them. Throws Failure where it cannot be run.
  explicit BackgroundProcess(const std::vector<std::string>& words);
  /// One that still runs is interrupted, with all that it has started.
  ~BackgroundProcess();
  BackgroundProcess(const BackgroundProcess&) = delete;
  BackgroundProcess& operator=(const BackgroundProcess&) = delete;

  struct End {
    bool done = false; // with an exit code of 0
    std::string talk;  // what it said on both streams; of very much, the beginning
  };
  /// Once, when it has ended; does not wait for that. Of one that says much it wants to be asked often.
  std::optional<End> ended();

private:
  void read_talk();

  pid_t child_ = -1; // nobody once its end is known
  int output_ = -1;
  std::string talk_;
};

} // namespace unghost
