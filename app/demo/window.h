// The window, and what a person does to it: keys, mouse, gamepad and dropped files, as plain data.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "renderer/gpu/device.h"

struct GLFWwindow;

namespace unghost {

/// What came since the last look, in its order.
struct WindowEvents {
  struct Press {
    int key = 0; // GLFW_KEY_*
    bool shift = false, control = false;
  };
  std::vector<Press> pressed;
  std::vector<int> buttons; // GLFW_GAMEPAD_BUTTON_*, pressed
  std::vector<std::filesystem::path> dropped;
  std::vector<std::string> gamepads;      // sentences: which came or went
  glm::dvec2 mouse{0};                    // where it went, in screen coordinates
  std::optional<glm::dvec2> left_pressed; // where the mouse was then, in pixels of the framebuffer
  double scroll = 0;
  struct Click {
    glm::dvec2 at{0}; // pixels of the framebuffer
    bool shift = false;
  };
  std::vector<Click> clicks; // of the left button, released where it was pressed
  glm::dvec2 pressed_at{0};  // where that was pressed last, screen coordinates
};

/// What is held at this moment. The mouse in pixels of the framebuffer; sticks from -1 to 1, right and down.
struct WindowHeld {
  glm::dvec2 mouse{0};
  bool left = false, right = false, middle = false, shift = false, control = false;
  glm::dvec3 fly{0}; // keys: right, up, forward
  glm::dvec2 left_stick{0}, right_stick{0};
};

class Window {
public:
  /// Throws Failure where there is no display. `size` in screen coordinates.
  Window(uint32_t width, uint32_t height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  SurfaceMaker surface_maker() const;
  /// Looks for events; waits up to `seconds` for one.
  WindowEvents events(double seconds);
  WindowHeld held() const;
  /// Whether that key is held.
  bool holds(int key) const;
  /// Pixels; zeros where it is minimised.
  VkExtent2D pixels() const;
  glm::ivec2 size() const; // screen coordinates
  /// Pixels a screen coordinate, and how much larger text should be than usual.
  double scale() const;
  bool full_screen() const;
  void toggle_full_screen();
  bool closed(); // since the last look
  void title(const std::string& text);
  void copy(const std::string& text);
  GLFWwindow* handle() const { return window_; }

private:
  void watch_gamepad();

  GLFWwindow* window_ = nullptr;
  WindowEvents coming_;
  std::vector<uint8_t> buttons_; // of the first gamepad, as they were
  std::string gamepad_;          // its name; empty where there is none
  glm::dvec2 left_stick_{0}, right_stick_{0};
  glm::ivec4 windowed_{0}; // place and size to come back to
};

} // namespace unghost
