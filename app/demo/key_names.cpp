#include "app/demo/actions.h"

#include <algorithm>
#include <iterator>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace unghost {
namespace {

struct Named {
  int code;
  std::string_view name;
};

std::string_view name_of(int code, std::span<const Named> names) {
  const auto found = std::ranges::find(names, code, &Named::code);
  return found == names.end() ? std::string_view{} : found->name;
}

} // namespace

std::string key_text(const Action& action) {
  static constexpr Named names[] = {
      {GLFW_KEY_ENTER, "Enter"}, {GLFW_KEY_SPACE, "Space"},         {GLFW_KEY_TAB, "Tab"},
      {GLFW_KEY_ESCAPE, "Esc"},  {GLFW_KEY_BACKSPACE, "Backspace"}, {GLFW_KEY_F11, "F11"},
      {GLFW_KEY_F12, "F12"},     {GLFW_KEY_HOME, "Home"},           {GLFW_KEY_DELETE, "Delete"},
  };
  std::string name(name_of(action.key, names));
  if (name.empty()) name = char(action.key); // GLFW's other keys are what a US keyboard has on them
  return (action.shift ? "Shift+" : "") + name;
}

std::string_view button_text(const Action& action) {
  static constexpr Named names[] = {
      {GLFW_GAMEPAD_BUTTON_A, "A"},
      {GLFW_GAMEPAD_BUTTON_B, "B"},
      {GLFW_GAMEPAD_BUTTON_X, "X"},
      {GLFW_GAMEPAD_BUTTON_Y, "Y"},
      {GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, "LB"},
      {GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, "RB"},
      {GLFW_GAMEPAD_BUTTON_BACK, "View"},
      {GLFW_GAMEPAD_BUTTON_START, "Start"},
      {GLFW_GAMEPAD_BUTTON_DPAD_UP, "DPad up"},
      {GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, "DPad right"},
      {GLFW_GAMEPAD_BUTTON_DPAD_DOWN, "DPad down"},
      {GLFW_GAMEPAD_BUTTON_DPAD_LEFT, "DPad left"},
  };
  return name_of(action.button, names);
}

} // namespace unghost
