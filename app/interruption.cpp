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

void throw_if_interrupted() {
  if (came != 0) throw Interrupted{came};
}

} // namespace unghost
