// How a run ends, and the one exception that our own code throws towards the end of it.
#pragma once

#include <stdexcept>
#include <string>

namespace unghost {

/// Exit codes; those of signals are 128 + the signal.
enum class Exit : int {
  done = 0,
  failed = 1,
  wrong_words = 2,
  input_refused = 3,
  no_device = 4,
  device_lost_or_memory = 5,
};

/// The world's fault; `what()` is the sentence that a person reads.
struct Failure : std::runtime_error {
  Failure(Exit code, const std::string& sentence) : std::runtime_error(sentence), exit(code) {}
  Exit exit;
};

} // namespace unghost
