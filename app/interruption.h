// Ctrl-C and termination: noted in the handler, thrown between two frames, so that unwinding leaves whole
// files or none. A second signal ends the process at once.
#pragma once

namespace unghost {

struct Interrupted {
  int signal;
};

/// For SIGINT and SIGTERM, until each has come once.
void catch_signals();
/// Whether a signal has come.
bool interrupted();
/// Throws Interrupted once a signal has come.
void throw_if_interrupted();

} // namespace unghost
