#include <csignal>
#include <iostream>

#include <fcntl.h>
#include <unistd.h>

#include "app/interruption.h"
#include "app/run.h"

namespace {

/// A file that is opened must not get the number of a stream that was closed: talk would be written into it.
void occupy_standard_streams() {
  for (int open_one = 0; open_one >= 0 && open_one <= STDERR_FILENO;)
    open_one = open("/dev/null", open_one == STDERR_FILENO ? O_WRONLY : O_RDONLY);
}

} // namespace

int main(int count, char** words) {
  std::ios::sync_with_stdio(false);
  occupy_standard_streams();
  signal(SIGPIPE, SIG_IGN); // a reader that has gone is an error of the write
  signal(SIGXFSZ, SIG_IGN); // and so is a file that may not grow
  unghost::catch_signals();
  const std::span<const char* const> all(words, size_t(count));
  return unghost::run(all.subspan(all.empty() ? 0 : 1), std::cout, std::cerr, isatty(STDERR_FILENO) != 0);
}
