#include "tests/window/pad.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <GLFW/glfw3.h>
#include <fcntl.h>
#include <linux/input.h>
#include <sys/stat.h>

namespace unghost {

struct Pad::Change {
  uint16_t type, code;
  int32_t value = 0;
};

namespace {

/// An event and what it is while the button is down; up is 0 for all.
struct Wire {
  uint16_t type, code;
  int32_t down = 1;
};

// In the order of GLFW's numbers. The directional pad is a pair of axes.
constexpr std::array<Wire, GLFW_GAMEPAD_BUTTON_LAST + 1> button_wires = {{{EV_KEY, BTN_A},
                                                                          {EV_KEY, BTN_B},
                                                                          {EV_KEY, BTN_X},
                                                                          {EV_KEY, BTN_Y},
                                                                          {EV_KEY, BTN_TL},
                                                                          {EV_KEY, BTN_TR},
                                                                          {EV_KEY, BTN_SELECT},
                                                                          {EV_KEY, BTN_START},
                                                                          {EV_KEY, BTN_MODE},
                                                                          {EV_KEY, BTN_THUMBL},
                                                                          {EV_KEY, BTN_THUMBR},
                                                                          {EV_ABS, ABS_HAT0Y, -1},
                                                                          {EV_ABS, ABS_HAT0X, 1},
                                                                          {EV_ABS, ABS_HAT0Y, 1},
                                                                          {EV_ABS, ABS_HAT0X, -1}}};
constexpr std::array<uint16_t, GLFW_GAMEPAD_AXIS_LAST + 1> axis_codes = {ABS_X,  ABS_Y, ABS_RX,
                                                                         ABS_RY, ABS_Z, ABS_RZ};

} // namespace

Pad::Pad(const Desk& desk, int number) : file_(desk.gamepads() / ("event" + std::to_string(number))) {}

Pad::~Pad() {
  if (descriptor_ >= 0) unplug();
}

void Pad::plug() {
  if (mkfifo(file_.c_str(), 0600) != 0) throw std::runtime_error("a gamepad is there: " + file_.string());
  // for reading, too: what is written before the program opens it waits there
  descriptor_ = open(file_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
}

void Pad::unplug() {
  std::filesystem::remove(file_);
  close(std::exchange(descriptor_, -1));
}

void Pad::send(Change change) {
  const input_event report[] = {{{}, change.type, change.code, change.value}, {{}, EV_SYN, SYN_REPORT, 0}};
  if (write(descriptor_, report, sizeof(report)) != sizeof(report))
    throw std::runtime_error("a gamepad is not plugged in, or nobody reads it");
}

void Pad::press(int button) {
  hold(button);
  let_go(button);
}

void Pad::hold(int button) {
  const Wire& wire = button_wires.at(size_t(button));
  send({wire.type, wire.code, wire.down});
}

void Pad::let_go(int button) {
  const Wire& wire = button_wires.at(size_t(button));
  send({wire.type, wire.code, 0});
}

void Pad::axis(int axis, float value) {
  const bool trigger = axis == GLFW_GAMEPAD_AXIS_LEFT_TRIGGER || axis == GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER;
  const float low = trigger ? 0 : -32768, high = trigger ? 255 : 32767;
  send({EV_ABS, axis_codes.at(size_t(axis)), int32_t(std::lround(low + (high - low) * (value + 1) / 2))});
}

} // namespace unghost
