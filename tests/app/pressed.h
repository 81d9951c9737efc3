// The demo, and the keys that are pressed.
#pragma once

#include <gtest/gtest.h>

#include "app/demo/actions.h"

namespace unghost {

inline ModeRun& shown(DemoState& state) { return state.modes[state.mode]; }

inline DemoState showing(std::string_view mode) {
  DemoState state = default_demo_state();
  show_mode(state, place_of_mode(state, mode));
  return state;
}

inline void press(DemoState& state, int key, bool shift = false) {
  const Action* action = action_for_key(key, shift);
  ASSERT_NE(action, nullptr) << key;
  perform(*action, state);
}

inline DemoState without_message(DemoState state) {
  state.message.clear();
  return state;
}

} // namespace unghost
