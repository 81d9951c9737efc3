// Which modes are seen, beside one another or alone, and as their rows of the table have them.
#include <algorithm>
#include <array>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/action_rows.h"

namespace unghost {
namespace {

constexpr size_t numbered = 10; // keys of digits

// The first of the table's rows that keep a history, and the one that is shown at first.
std::vector<std::string_view> numbered_modes() {
  std::vector<std::string_view> names;
  for (const TaaMode& row : taa_modes())
    if (row.settings.policy.needs_history() && names.size() < numbered - 1) names.push_back(row.name);
  names.push_back(default_taa_mode);
  return names;
}

template <size_t number> void show_numbered(DemoState& state) {
  static const std::vector<std::string_view> names = numbered_modes();
  show_mode(state, place_of_mode(state, names[number]));
}

template <size_t... number> std::vector<Action> rows_of_digits(std::index_sequence<number...>) {
  constexpr std::array<void (*)(DemoState&), numbered> shows = {show_numbered<number>...};
  const std::vector<std::string_view> names = numbered_modes();
  std::vector<Action> rows;
  for (size_t i = 0; i < names.size(); ++i)
    rows.push_back({.name = "mode",
                    .key = GLFW_KEY_0 + int((i + 1) % numbered), // 1 to 9, and 0 to the right of them
                    .what = "Show " + std::string(names[i]),
                    .apply = shows[i],
                    .present = shown_name});
  return rows;
}

template <int step> void show_neighbour(DemoState& state) {
  show_mode(state, (state.mode + state.modes.size() + size_t(step)) % state.modes.size());
}

void switch_comparison(DemoState& state) {
  const bool on = state.arrangement == Arrangement::single;
  state.arrangement = on ? Arrangement::split : Arrangement::single;
  if (state.compared.empty()) state.compared = {(state.mode + 1) % state.modes.size()};
}

std::string comparison_present(const DemoState& state) {
  if (state.arrangement == Arrangement::single) return "off";
  return std::string(spelling(state.arrangement)) + " with " + state.modes[state.compared.front()].name;
}

bool compares(const DemoState& state) { return state.arrangement != Arrangement::single; }

/// Through those of several modes.
void show_next_arrangement(DemoState& state) {
  const std::span<const Answer> all = answers<Arrangement>();
  if (!compares(state)) return switch_comparison(state);
  const auto now = std::ranges::find(all, uint32_t(state.arrangement), &Answer::value);
  const auto next = now + 1 == all.end() ? all.begin() : now + 1;
  state.arrangement = Arrangement(next->value);
  if (!compares(state)) show_next_arrangement(state);
}

std::string no_room_for_one_more(const DemoState& state) {
  if (!compares(state)) return "nothing is compared";
  return modes_seen(state).size() > most_compared ? "four are the most" : "";
}

std::string no_one_less(const DemoState& state) {
  if (!compares(state)) return "nothing is compared";
  return state.compared.size() < 2 ? "two are the least" : "";
}

std::string compared_present(const DemoState& state) {
  std::string names;
  for (const size_t mode : modes_seen(state)) names += (names.empty() ? "" : ", ") + state.modes[mode].name;
  return names;
}

std::string as_its_row(const DemoState& state) { return is_changed(state) ? "" : "it is as its row has it"; }

std::string is_as_at_first(const DemoState& state) {
  DemoState reset = state;
  reset_all(reset);
  reset.message = state.message;
  return reset == state ? "it is" : "";
}

} // namespace

std::vector<Action> numbered_mode_rows() { return rows_of_digits(std::make_index_sequence<numbered>()); }

// clang-format off
std::vector<Action> mode_rows() {
  return {
    {"mode", GLFW_KEY_LEFT_BRACKET, false, no_button, "Previous mode", show_neighbour<-1>, says_nothing, shown_name},
    {"mode", GLFW_KEY_RIGHT_BRACKET, false, no_button, "Next mode", show_neighbour<1>, says_nothing, shown_name},
    {"comparison", GLFW_KEY_B, false, no_button, "Compare two modes, or see one", switch_comparison, says_nothing, comparison_present},
    {"arrangement", GLFW_KEY_B, true, no_button, "Next way to compare: bar, grid, difference, FLIP", show_next_arrangement, says_nothing, comparison_present},
    {"compared", GLFW_KEY_EQUAL, false, no_button, "One mode more in a grid", compare_one_more, no_room_for_one_more, compared_present},
    {"compared", GLFW_KEY_MINUS, false, no_button, "One mode less in a grid", compare_one_less, no_one_less, compared_present},
    {"settings", GLFW_KEY_DELETE, false, no_button, "The mode as its row of the table has it", reset_mode, as_its_row, shown_name},
    {"everything", GLFW_KEY_DELETE, true, no_button, "Everything but the scene as in the first run", reset_all, is_as_at_first, says_nothing},
  };
}
// clang-format on

} // namespace unghost
