// The parts of the table of actions, a file each, and what their rows have in common.
#pragma once

#include <vector>

#include "app/demo/actions.h"

namespace unghost {

// In a row: name, key, Shift, button, what, what it does, why not, its present state.
std::vector<Action> sample_rows();
std::vector<Action> numbered_mode_rows(); // the digits
std::vector<Action> mode_rows();
std::vector<Action> picture_rows();
std::vector<Action> path_rows();
std::vector<Action> window_rows();

/// What the shown mode is drawn with.
Settings shown_settings(const DemoState& state);
/// In the shown mode where it is a mode's own, else in all of them.
void change_setting(DemoState& state, const Setting& row, double value);
/// Why it has none on the shown mode; empty where it has one.
std::string without_effect(const DemoState& state, const Setting& row);
/// On to the next answer, one way round or the other, that goes with the rest of the settings.
void cycle(DemoState& state, const Setting& row, int step);
/// Of the shown mode.
std::string shown_name(const DemoState& state);

template <const char* setting, int step> Action cycles(Action action) {
  action.apply = [](DemoState& s) { cycle(s, find_setting(setting), step); };
  action.why_not = [](const DemoState& s) { return without_effect(s, find_setting(setting)); };
  action.present = [](const DemoState& s) { return find_setting(setting).get(shown_settings(s)); };
  return action;
}

/// `toggles<&DemoState::magnifier, &Magnifier::shown>`: what lies at that path, inwards.
template <auto... path> Action toggles(Action action) {
  action.apply = [](DemoState& s) { (s.*....*path) = !(s.*....*path); };
  action.present = [](const DemoState& s) { return std::string((s.*....*path) ? "on" : "off"); };
  return action;
}

template <auto member> void request(DemoState& state) { state.requests.*member = true; }

} // namespace unghost
