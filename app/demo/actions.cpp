#include "app/demo/actions.h"

#include <algorithm>
#include <iterator>

#include "app/demo/action_rows.h"

namespace unghost {
namespace {

std::vector<Action> table() {
  std::vector<Action> rows;
  for (const auto part : {sample_rows, numbered_mode_rows, mode_rows, picture_rows, path_rows, window_rows})
    std::ranges::move(part(), std::back_inserter(rows));
  return rows;
}

} // namespace

std::span<const Action> actions() {
  static const std::vector<Action> rows = table();
  return rows;
}

const Action* action_for_key(int key, bool shift) {
  const Action* found = nullptr;
  for (const Action& row : actions())
    if (row.key == key && (row.shift == shift || (shift && found == nullptr))) found = &row;
  return found;
}

const Action* action_for_button(int button) {
  const auto found = std::ranges::find(actions(), button, &Action::button);
  return button == no_button || found == actions().end() ? nullptr : &*found;
}

void perform(const Action& action, DemoState& state) {
  std::string outcome = action.why_not(state);
  if (outcome.empty()) {
    action.apply(state);
    outcome = action.present(state);
  }
  state.message = std::string(action.name) + (outcome.empty() ? "" : ": " + outcome);
}

} // namespace unghost
