#include "app/demo/window.h"

#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/failure.h"
#include "renderer/gpu/vk.h"

namespace unghost {
namespace {

constexpr int pad = GLFW_JOYSTICK_1;
constexpr double dead_zone = 0.15; // of a stick: none rests in its very middle

constexpr double slack = 3; // screen coordinates that a click may move: no hand is quite still

[[noreturn]] void fail(const char* doing) {
  const char* why = nullptr;
  glfwGetError(&why);
  throw Failure(Exit::failed, std::string("cannot open a window (") + doing +
                                  "): " + (why != nullptr ? why : "no reason given") +
                                  "; `unghost capture` and `unghost compare` draw without one");
}

double live(float value) {
  const double size = std::abs(double(value));
  return size < dead_zone ? 0 : std::copysign((size - dead_zone) / (1 - dead_zone), double(value));
}

WindowEvents& events_of(GLFWwindow* window) {
  return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

glm::dvec2 mouse_of(GLFWwindow* window) {
  glm::dvec2 at(0);
  glfwGetCursorPos(window, &at.x, &at.y);
  return at;
}

void on_key(GLFWwindow* window, int key, int, int action, int modifiers) {
  if (action != GLFW_PRESS || key == GLFW_KEY_UNKNOWN) return; // held, a key would flicker
  events_of(window).pressed.push_back({.key = key,
                                       .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                                       .control = (modifiers & GLFW_MOD_CONTROL) != 0});
}

void on_scroll(GLFWwindow* window, double, double steps) { events_of(window).scroll += steps; }

void on_button(GLFWwindow* window, int button, int action, int modifiers) {
  if (button != GLFW_MOUSE_BUTTON_LEFT) return;
  // glfwGetCursorPos would tell where it is by now, which a slow frame later is elsewhere
  WindowEvents& events = events_of(window);
  if (action == GLFW_PRESS)
    events.left_pressed = events.pressed_at = events.mouse;
  else if (glm::distance(events.mouse, events.pressed_at) <= slack)
    events.clicks.push_back({.at = events.mouse, .shift = (modifiers & GLFW_MOD_SHIFT) != 0});
}

void on_mouse(GLFWwindow* window, double x, double y) { events_of(window).mouse = {x, y}; }

void on_drop(GLFWwindow* window, int count, const char** paths) {
  for (int i = 0; i < count; ++i) events_of(window).dropped.emplace_back(paths[i]);
}

} // namespace

Window::Window(uint32_t width, uint32_t height) {
  if (glfwInit() != GLFW_TRUE) fail("finding a display");
  if (glfwVulkanSupported() != GLFW_TRUE) {
    glfwTerminate();
    throw GpuError(GpuFault::no_device, "no Vulkan driver was found that can show anything in a window");
  }
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(int(width), int(height), "unghost", nullptr, nullptr);
  if (window_ == nullptr) {
    glfwTerminate();
    fail("making it");
  }
  glfwSetWindowSizeLimits(window_, 160, 90, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetWindowUserPointer(window_, &coming_);
  glfwSetKeyCallback(window_, on_key);
  glfwSetScrollCallback(window_, on_scroll);
  glfwSetMouseButtonCallback(window_, on_button);
  glfwSetCursorPosCallback(window_, on_mouse);
  glfwSetDropCallback(window_, on_drop);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

SurfaceMaker Window::surface_maker() const {
  uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  return {.extensions = {names, names + count}, .make = [window = window_](VkInstance instance) {
            VkSurfaceKHR surface = VK_NULL_HANDLE;
            check(glfwCreateWindowSurface(instance, window, nullptr, &surface), "preparing the window");
            return surface;
          }};
}

void Window::watch_gamepad() {
  GLFWgamepadstate state{};
  const bool there = glfwGetGamepadState(pad, &state) == GLFW_TRUE;
  const std::string name = there ? glfwGetGamepadName(pad) : "";
  if (name != gamepad_) coming_.gamepads.push_back(there ? name + " is connected" : gamepad_ + " is gone");
  gamepad_ = name;
  buttons_.resize(GLFW_GAMEPAD_BUTTON_LAST + 1);
  for (int button = 0; button <= GLFW_GAMEPAD_BUTTON_LAST; ++button) {
    const uint8_t now = there ? state.buttons[button] : uint8_t(GLFW_RELEASE);
    if (now == GLFW_PRESS && buttons_[size_t(button)] == GLFW_RELEASE) coming_.buttons.push_back(button);
    buttons_[size_t(button)] = now;
  }
  // here, as whoever asks for the state again takes a press away from the next look
  const auto stick = [&](int x, int y) {
    return there ? glm::dvec2(live(state.axes[x]), live(state.axes[y])) : glm::dvec2(0);
  };
  left_stick_ = stick(GLFW_GAMEPAD_AXIS_LEFT_X, GLFW_GAMEPAD_AXIS_LEFT_Y);
  right_stick_ = stick(GLFW_GAMEPAD_AXIS_RIGHT_X, GLFW_GAMEPAD_AXIS_RIGHT_Y);
}

WindowEvents Window::events(double seconds) {
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  watch_gamepad();
  WindowEvents came = std::exchange(coming_, {});
  coming_.mouse = came.mouse, coming_.pressed_at = came.pressed_at;
  if (came.left_pressed) *came.left_pressed *= scale();
  for (WindowEvents::Click& click : came.clicks) click.at *= scale();
  return came;
}

bool Window::holds(int key) const { return glfwGetKey(window_, key) == GLFW_PRESS; }

WindowHeld Window::held() const {
  WindowHeld held;
  held.mouse = mouse_of(window_) * scale();
  const auto button = [&](int which) { return glfwGetMouseButton(window_, which) == GLFW_PRESS; };
  held.left = button(GLFW_MOUSE_BUTTON_LEFT), held.right = button(GLFW_MOUSE_BUTTON_RIGHT);
  held.middle = button(GLFW_MOUSE_BUTTON_MIDDLE);
  held.shift = holds(GLFW_KEY_LEFT_SHIFT) || holds(GLFW_KEY_RIGHT_SHIFT);
  held.control = holds(GLFW_KEY_LEFT_CONTROL) || holds(GLFW_KEY_RIGHT_CONTROL);
  held.fly = {int(holds(GLFW_KEY_D)) - int(holds(GLFW_KEY_A)),
              int(holds(GLFW_KEY_E)) - int(holds(GLFW_KEY_Q)),
              int(holds(GLFW_KEY_W)) - int(holds(GLFW_KEY_S))};
  held.left_stick = left_stick_, held.right_stick = right_stick_;
  return held;
}

VkExtent2D Window::pixels() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  const bool hidden = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE;
  return hidden ? VkExtent2D{} : VkExtent2D{uint32_t(width), uint32_t(height)};
}

glm::ivec2 Window::size() const {
  glm::ivec2 size(0);
  glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

double Window::scale() const {
  const glm::ivec2 coordinates = size();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  return coordinates.x > 0 ? double(width) / coordinates.x : 1;
}

bool Window::full_screen() const { return glfwGetWindowMonitor(window_) != nullptr; }

void Window::toggle_full_screen() {
  if (full_screen()) {
    glfwSetWindowMonitor(window_, nullptr, windowed_.x, windowed_.y, windowed_.z, windowed_.w, 0);
    return;
  }
  glfwGetWindowPos(window_, &windowed_.x, &windowed_.y);
  glfwGetWindowSize(window_, &windowed_.z, &windowed_.w);
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode != nullptr)
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool Window::closed() {
  const bool asked = glfwWindowShouldClose(window_) == GLFW_TRUE;
  glfwSetWindowShouldClose(window_, GLFW_FALSE);
  return asked;
}

void Window::title(const std::string& text) { glfwSetWindowTitle(window_, text.c_str()); }
void Window::copy(const std::string& text) { glfwSetClipboardString(window_, text.c_str()); }

} // namespace unghost
