#include "app/interruption.h"

#include <csignal>

namespace unghost {
namespace {

volatile std::sig_atomic_t came = 0;

void note(int signal) { came = signal; }

} // namespace

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return came != 0; }

void throw_if_interrupted() {
  if (interrupted()) throw Interrupted{came};
}

} // namespace unghost
