#include <iostream>

#include <unistd.h>

#include "app/interruption.h"
#include "app/run.h"

int main(int count, char** words) {
  std::ios::sync_with_stdio(false);
  unghost::catch_signals();
  const std::span<const char* const> all(words, size_t(count));
  return unghost::run(all.subspan(all.empty() ? 0 : 1), std::cout, std::cerr, isatty(STDERR_FILENO) != 0);
}
