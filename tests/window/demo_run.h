// A program with a window, run on a desk and told apart by what it prints: one JSON object a line, `ready`
// when it has drawn, and one for each change of its state.
#pragma once

#include <csignal>

#include <nlohmann/json.hpp>

#include "tests/window/desk.h"
#include "tests/window/pad.h"

namespace unghost {

class DemoRun {
public:
  /// Starts it and waits until it is ready, drops what it said before, and finds its window. `words` begin
  /// with the program; `environment` are NAME=value. It keeps its things in the desk's home, where the next
  /// run finds them, and shows the desk's gamepads.
  explicit DemoRun(const Desk& desk, const Words& words, const Words& environment = {});

  const nlohmann::json& ready() const { return ready_; }
  const DeskWindow& window() const { return *window_; }

  /// The next event, whatever it is; nothing where none comes in time.
  std::optional<nlohmann::json> next_event(Milliseconds limit);
  /// The next event of that action; those before it are dropped.
  nlohmann::json expect_event(const std::string& action);
  /// Presses, and returns what the program says to it.
  nlohmann::json press(const std::string& key, const std::string& action);
  nlohmann::json press(Pad& pad, int button, const std::string& action);

  /// As Ctrl-C does it in a terminal.
  void interrupt() const { process_.signal(SIGINT); }
  /// No file that it writes may get larger than that, as on a disk that is full; nothing: all may.
  void limit_files(std::optional<uint64_t> bytes) const { process_.limit_files(bytes); }
  /// Presses Escape; the exit code.
  int leave();
  /// The exit code of a program that ends by other means.
  int ended();
  int ended_by(int signal) { return process_.signal(signal), ended(); }
  /// What it said on standard error.
  std::string talk() const { return process_.talk(); }

private:
  nlohmann::json parsed(const std::string& line) const;

  Process process_;
  nlohmann::json ready_ = nlohmann::json::object();
  std::optional<DeskWindow> window_;
};

} // namespace unghost
