// A whole run of the program, without the process around it.
#pragma once

#include <ostream>
#include <span>

namespace unghost {

/// `words` without the program's name. Returns the exit code; a fault is one sentence on `err`. `terminal`:
/// err is one, and progress may be shown there.
int run(std::span<const char* const> words, std::ostream& out, std::ostream& err, bool terminal = false);

} // namespace unghost
