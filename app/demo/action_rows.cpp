#include "app/demo/action_rows.h"

#include <algorithm>

namespace unghost {

Settings shown_settings(const DemoState& state) { return settings_of(state, state.mode); }

void change_setting(DemoState& state, const Setting& row, double value) {
  Settings settings = shown_settings(state);
  row.write(settings, value);
  state.modes[state.mode].taa = settings.taa;
  settings.taa = state.settings.taa; // which belongs to no mode
  state.settings = settings;
}

std::string without_effect(const DemoState& state, const Setting& row) {
  const bool used = row.used.met_by(shown_settings(state));
  return used ? std::string{} : std::string(row.used.otherwise);
}

void cycle(DemoState& state, const Setting& row, int step) {
  Settings settings = shown_settings(state);
  const auto now = std::ranges::find(row.answers, uint32_t(row.read(settings)), &Answer::value);
  const ptrdiff_t count = ptrdiff_t(row.answers.size());
  ptrdiff_t place = now - row.answers.begin();
  do {
    place = (place + step + count) % count;
    row.write(settings, row.answers[size_t(place)].value);
  } while (refusal(settings) && &row.answers[size_t(place)] != &*now);
  change_setting(state, row, row.answers[size_t(place)].value);
}

std::string shown_name(const DemoState& state) { return state.modes[state.mode].name; }

} // namespace unghost
