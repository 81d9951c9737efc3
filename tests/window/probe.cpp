// A window that draws nothing and prints what reaches it, as one JSON object a line: what the desk's own
// tests run. It polls once every so many milliseconds (its first word), as a program that draws would. Escape
// ends it.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

// as in GLFW/glfw3native.h, which wants Xrandr's headers for what is not asked here
extern "C" Display* glfwGetX11Display();
extern "C" Window glfwGetX11Window(GLFWwindow* window);

namespace {

int first_pad = -1; // of those that are plugged in

void print(const char* event, const std::string& action, const nlohmann::json& state) {
  std::puts(
      nlohmann::json{{"event", event}, {"action", action}, {"message", ""}, {"state", state}}.dump().c_str());
  std::fflush(stdout);
}

const char* word(int action) {
  return action == GLFW_RELEASE ? " up" : action == GLFW_PRESS ? " down" : " again";
}

void find_pad() {
  first_pad = -1;
  for (int pad = GLFW_JOYSTICK_LAST; pad >= 0; pad--)
    if (glfwJoystickIsGamepad(pad)) first_pad = pad;
}

void listen(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* source, int key, int, int action, int) {
    print("key", "key " + std::to_string(key) + word(action), {});
    if (key == GLFW_KEY_ESCAPE && action == GLFW_PRESS) glfwSetWindowShouldClose(source, true);
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* source, int button, int action, int) {
    double x, y;
    glfwGetCursorPos(source, &x, &y);
    print("mouse", "mouse " + std::to_string(button) + word(action), {{"x", x}, {"y", y}});
  });
  glfwSetScrollCallback(
      window, [](GLFWwindow*, double, double y) { print("mouse", y > 0 ? "scroll up" : "scroll down", {}); });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow*, int width, int height) {
    print("window", "resized", {{"width", width}, {"height", height}});
  });
  glfwSetWindowIconifyCallback(
      window, [](GLFWwindow*, int iconic) { print("window", iconic ? "minimised" : "restored", {}); });
  glfwSetJoystickCallback([](int, int event) {
    find_pad();
    if (event == GLFW_DISCONNECTED) return print("gamepad", "unplugged", {});
    print("gamepad", "plugged",
          {{"guid", glfwGetJoystickGUID(first_pad)}, {"name", glfwGetGamepadName(first_pad)}});
  });
}

/// Prints how the gamepad's state differs from what it was. A stick at rest is half a step from the middle of
/// its range.
void follow(GLFWgamepadstate& before) {
  GLFWgamepadstate now = {};
  // asks twice, as programs do that look whether it is there
  if (first_pad < 0 || !glfwJoystickIsGamepad(first_pad) || !glfwGetGamepadState(first_pad, &now)) return;
  for (int i = 0; i <= GLFW_GAMEPAD_BUTTON_LAST; i++)
    if (now.buttons[i] != before.buttons[i])
      print("button", "button " + std::to_string(i) + word(now.buttons[i]), {});
  for (int i = 0; i <= GLFW_GAMEPAD_AXIS_LAST; i++)
    if (std::abs(now.axes[i] - before.axes[i]) > 1e-4f)
      print("axis", "axis " + std::to_string(i), {{"value", now.axes[i]}});
  before = now;
}

/// Squares of 8 pixels, red at the window's upper left corner and blue elsewhere, in tiles of two by two.
void paint(GLFWwindow* window) {
  Display* display = glfwGetX11Display();
  const Window target = glfwGetX11Window(window);
  const Pixmap tile = XCreatePixmap(display, target, 16, 16, 24);
  const GC pen = XCreateGC(display, tile, 0, nullptr);
  XSetForeground(display, pen, 0x204080);
  XFillRectangle(display, tile, pen, 0, 0, 16, 16);
  XSetForeground(display, pen, 0xff4020);
  XFillRectangle(display, tile, pen, 0, 0, 8, 8);
  XSetWindowBackgroundPixmap(display, target, tile);
  XClearWindow(display, target);
  XFreeGC(display, pen);
  XFreePixmap(display, tile);
  XSync(display, False);
}

} // namespace

int main(int count, char** words) {
  if (!glfwInit()) return EXIT_FAILURE;
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  GLFWwindow* window = glfwCreateWindow(200, 120, "probe", nullptr, nullptr);
  if (window == nullptr) return EXIT_FAILURE;
  glfwSetWindowPos(window, 40, 30);
  listen(window);
  find_pad();
  paint(window);
  print("ready", "ready",
        {{"gamepad", first_pad >= 0}, {"config", std::getenv("XDG_CONFIG_HOME")}, {"pid", int(getpid())}});
  const std::chrono::milliseconds frame(count > 1 ? std::atoi(words[1]) : 5);
  GLFWgamepadstate pad = {};
  pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = -1;
  while (!glfwWindowShouldClose(window)) {
    glfwPollEvents();
    follow(pad);
    std::this_thread::sleep_for(frame);
  }
  std::fputs("probe: goodbye\n", stderr);
  glfwTerminate();
}
