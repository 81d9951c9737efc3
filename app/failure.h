// How a run ends, and the one exception that our own code throws towards the end of it.
#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

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

/// Writes what the validation layer has said; where that is anything, the run has failed.
void report_validation(std::ostream& to, const std::vector<std::string>& messages);

} // namespace unghost
