// What keys and buttons do: one row each. The window's input, the help on the screen, the panel and the
// README's table iterate over the rows.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "app/demo/demo_state.h"

namespace unghost {

constexpr int no_button = -1;

inline std::string says_nothing(const DemoState&) { return {}; }

struct Action {
  std::string_view name;  // of what it changes; what it did is told as "name: present"
  int key = 0;            // GLFW_KEY_
  bool shift = false;     // that key's second meaning
  int button = no_button; // GLFW_GAMEPAD_BUTTON_
  std::string what;       // for the help and the README
  void (*apply)(DemoState&) = nullptr;
  std::string (*why_not)(const DemoState&) = says_nothing; // empty where it has an effect
  std::string (*present)(const DemoState&) = says_nothing; // "catmull-rom-9", "on"
};

std::span<const Action> actions();
/// Nothing where the key has no row; one that has no second meaning does the same with Shift.
const Action* action_for_key(int key, bool shift);
const Action* action_for_button(int button);
/// Does it, or says in the message why it has no effect.
void perform(const Action& action, DemoState& state);

/// As keyboards have it: "Shift+N".
std::string key_text(const Action& action);
/// As an Xbox gamepad has it: "DPad up"; empty where there is none.
std::string_view button_text(const Action& action);

} // namespace unghost
