// A gamepad on a desk, for a program that runs under fake_gamepad.
#pragma once

#include <initializer_list>

#include "tests/window/desk.h"

struct input_event;

namespace unghost {

/// Buttons and axes are GLFW's: GLFW_GAMEPAD_BUTTON_A, GLFW_GAMEPAD_AXIS_LEFT_X. The program sees each call
/// as it polls for events, in that order, and a press at one poll and its end at the next one, however slow
/// it is.
class Pad {
public:
  /// `number` is the order in which a program finds those that are there when it starts.
  explicit Pad(const Desk& desk, int number = 0);
  ~Pad();
  Pad(const Pad&) = delete;
  Pad& operator=(const Pad&) = delete;

  void plug();
  /// With what the program has not seen yet.
  void unplug();
  void press(int button);
  void hold(int button);
  void let_go(int button);
  /// -1 to 1, and y grows downwards; a trigger rests at -1.
  void axis(int axis, float value);

private:
  struct Change;
  void send(Change change);

  std::filesystem::path file_;
  int descriptor_ = -1; // of the FIFO, where it is plugged in
};

} // namespace unghost
