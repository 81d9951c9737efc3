// How far long work has come, on a terminal: one line, drawn again.
#pragma once

#include <chrono>
#include <string>

#include "app/commands.h"

namespace unghost {

class Progress {
public:
  /// `work` in any unit; nothing is shown in a pipe or where quiet is asked for.
  Progress(const Console& console, double work);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// What is worked on now.
  void name(std::string what) { what_ = std::move(what); }
  void step(double work);
  /// Work that turned out not to be needed.
  void skip(double work) { left_out_ += work; }
  double done() const { return done_; }

private:
  using Clock = std::chrono::steady_clock;

  void show();

  const Console& console_;
  std::string what_;
  double work_, done_ = 0, left_out_ = 0;
  Clock::time_point begin_ = Clock::now(), shown_{};
};

/// "2 min 10 s", "8 s", "1 h 3 min".
std::string duration_text(double seconds);

} // namespace unghost
