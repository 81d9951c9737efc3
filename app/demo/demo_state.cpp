#include "app/demo/demo_state.h"

#include <algorithm>

namespace unghost {

DemoState default_demo_state() {
  DemoState state;
  for (const TaaMode& row : taa_modes())
    state.modes.push_back({.name = std::string(row.name), .taa = row.settings});
  state.mode = state.shown_before = place_of_mode(state, default_taa_mode);
  state.compared = {place_of_mode(state, "blend")}; // with a ghost, as the shown one has none
  return state;
}

glm::ivec2 pixel_of(const Picked& picked, glm::ivec2 picture_px) {
  return glm::clamp(glm::ivec2(glm::floor(picked.at * glm::dvec2(picture_px))), glm::ivec2(0),
                    picture_px - 1);
}

Settings settings_of(const DemoState& state, size_t mode) {
  Settings settings = state.settings;
  settings.taa = state.modes[mode].taa;
  return settings;
}

std::vector<size_t> modes_seen(const DemoState& state) {
  std::vector<size_t> seen = {state.mode};
  if (state.arrangement == Arrangement::single) return seen;
  seen.insert(seen.end(), state.compared.begin(), state.compared.end());
  const size_t most = state.arrangement == Arrangement::grid ? most_compared + 1 : 2;
  seen.resize(std::min(seen.size(), most));
  return seen;
}

void show_mode(DemoState& state, size_t mode) {
  if (mode == state.mode) return;
  std::ranges::replace(state.compared, mode, state.mode);
  state.shown_before = state.mode;
  state.mode = mode;
}

void compare_with(DemoState& state, size_t place, size_t mode) {
  if (mode == state.mode) return show_mode(state, state.compared[place]);
  std::ranges::replace(state.compared, mode, state.compared[place]);
  state.compared[place] = mode;
}

void compare_one_more(DemoState& state) {
  if (state.compared.size() == most_compared) return;
  if (!state.compared.empty()) state.arrangement = Arrangement::grid;
  for (size_t mode = 0; mode < state.modes.size(); ++mode)
    if (mode != state.mode && std::ranges::find(state.compared, mode) == state.compared.end())
      return state.compared.push_back(mode);
}

void compare_one_less(DemoState& state) {
  if (state.compared.size() > 1) state.compared.pop_back();
}

bool is_changed(const DemoState& state) {
  return !(state.modes[state.mode].taa == taa_modes()[state.mode].settings);
}

void reset_mode(DemoState& state) { state.modes[state.mode].taa = taa_modes()[state.mode].settings; }

void reset_all(DemoState& state) {
  DemoState fresh = default_demo_state();
  fresh.scene = state.scene;
  fresh.rig_frame = state.rig_frame, fresh.rig_frame_shown = state.rig_frame_shown;
  fresh.bookmarks = state.bookmarks;
  fresh.recorded = state.recorded, fresh.replayed = state.replayed, fresh.path_file = state.path_file;
  fresh.requests = state.requests;
  state = std::move(fresh);
}

void keep_bookmark(DemoState& state) {
  state.bookmark = state.bookmarks.size();
  state.bookmarks.push_back({.rig = state.rig, .rig_frame = state.rig_frame_shown, .camera = state.camera});
}

void go_to_bookmark(DemoState& state, size_t place) {
  state.rig = state.bookmarks[place].rig;
  state.rig_frame = state.bookmarks[place].rig_frame;
  look_as_bookmark(state, place);
}

void look_as_bookmark(DemoState& state, size_t place) {
  state.camera = state.bookmarks[place].camera;
  state.bookmark = place;
  state.requests.drop_history = true;
  state.requests.step = true; // it is seen while paused, too
}

void forget_bookmark(DemoState& state, size_t place) {
  state.bookmarks.erase(state.bookmarks.begin() + ptrdiff_t(place));
  if (state.bookmark == place)
    state.bookmark.reset();
  else if (state.bookmark && *state.bookmark > place)
    --*state.bookmark;
}

size_t place_of_mode(const DemoState& state, std::string_view name) {
  const auto found = std::ranges::find(state.modes, name, &ModeRun::name);
  if (found == state.modes.end()) {
    std::vector<std::string> names;
    for (const ModeRun& run : state.modes) names.push_back(run.name);
    throw SettingError("there is no mode '" + std::string(name) + "'" + did_you_mean(name, names));
  }
  return size_t(found - state.modes.begin());
}

} // namespace unghost
