// What the picture shows in its place, and how it goes on.
#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/action_rows.h"

namespace unghost {
namespace {

constexpr char view[] = "view";

std::string not_paused(const DemoState& state) { return state.paused ? "" : "nothing is paused"; }

std::string no_history(const DemoState& state) {
  const bool keeps = std::ranges::any_of(
      modes_seen(state), [&](size_t place) { return state.modes[place].taa.policy.needs_history(); });
  return keeps ? "" : shown_name(state) + " keeps none";
}

std::string dropped(const DemoState& state) { return state.requests.drop_history ? "dropped" : ""; }

std::string nothing_compared(const DemoState& state) {
  if (state.arrangement != Arrangement::single) return "they are all shown";
  return state.compared.empty() ? "nothing is compared" : "";
}

std::string flicker_present(const DemoState& state) { return state.modes[state.compared.front()].name; }

std::string no_magnifier(const DemoState& state) { return state.magnifier.shown ? "" : "it is not shown"; }

std::string nothing_picked(const DemoState& state) {
  return state.picked ? "" : "none is picked: click on one";
}

} // namespace

// clang-format off
std::vector<Action> picture_rows() {
  return {
    cycles<view, 1>({"view", GLFW_KEY_N, false, no_button, "Next view in place of the picture"}),
    cycles<view, -1>({"view", GLFW_KEY_N, true, no_button, "Previous view"}),
    toggles<&DemoState::paused>({"pause", GLFW_KEY_P, false, no_button, "Pause, or go on"}),
    {"one frame", GLFW_KEY_PERIOD, false, no_button, "One frame more, while paused", request<&DemoRequests::step>, not_paused},
    {"history", GLFW_KEY_BACKSPACE, false, no_button, "Drop the history", request<&DemoRequests::drop_history>, no_history, dropped},
    {"flicker", GLFW_KEY_K, false, no_button, "Held: the compared mode in its place", [](DemoState&) {}, nothing_compared, flicker_present},
    toggles<&DemoState::magnifier_follows>({"magnifier at the mouse", GLFW_KEY_V, true, no_button, "Let the magnifier follow the mouse", nullptr, no_magnifier}),
    {"pixel", GLFW_KEY_I, false, no_button, "Ask no more about the pixel that was clicked on", [](DemoState& s) { s.picked.reset(); }, nothing_picked, [](const DemoState& s) { return std::string(s.picked ? "picked" : "none"); }},
  };
}
// clang-format on

} // namespace unghost
