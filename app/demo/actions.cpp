#include "app/demo/actions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/measure/results.h"
#include "app/rigs.h"

namespace unghost {
namespace {

constexpr char dilation[] = "dilation", rectify[] = "rectify", jitter[] = "jitter", history[] = "history",
               jitter_scale[] = "jitter-scale", sharpen[] = "sharpen", view[] = "view";
constexpr float least_jitter = 0.2f, most_jitter = 1, usual_sharpening = 0.5f;
constexpr size_t numbered = 10; // keys of digits

Settings shown_settings(const DemoState& state) { return settings_of(state, state.mode); }

void change_setting(DemoState& state, const Setting& row, double value) {
  Settings settings = shown_settings(state);
  row.write(settings, value);
  state.modes[state.mode].taa = settings.taa;
  settings.taa = state.settings.taa; // which belongs to no mode
  state.settings = settings;
}

std::string without_effect(const DemoState& state, const Setting& row) {
  const bool used = !row.used.holds || row.used.holds(shown_settings(state));
  return used ? std::string{} : std::string(row.used.otherwise);
}

/// On to the next answer, one way round or the other, that goes with the rest of the settings.
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

std::string shown_name(const DemoState& state) { return state.modes[state.mode].name; }
bool taa_is_off(const DemoState& state) { return shown_name(state) == no_taa; }

void switch_taa(DemoState& state) {
  show_mode(state, taa_is_off(state) ? state.shown_before : place_of_mode(state, no_taa));
}

std::string taa_present(const DemoState& state) {
  return taa_is_off(state) ? "off" : "on, " + shown_name(state);
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

float jitter_scale_of(const DemoState& state) { return state.modes[state.mode].taa.jitter_scale; }

// To whole tenths: ten steps of 0.1f are not 1.
template <int step> void change_jitter_scale(DemoState& state) {
  const double tenths = std::round(10 * double(jitter_scale_of(state))) + step;
  change_setting(state, find_setting(jitter_scale),
                 std::clamp(float(tenths / 10), least_jitter, most_jitter));
}

template <int step> Action jitter_scales(Action action) {
  action.apply = change_jitter_scale<step>;
  action.why_not = [](const DemoState& s) -> std::string {
    const float scale = jitter_scale_of(s);
    if (step > 0 ? scale >= most_jitter : scale <= least_jitter)
      return step > 0 ? "1 is the most" : "0.2 is the least";
    return without_effect(s, find_setting(jitter_scale));
  };
  action.present = [](const DemoState& s) { return find_setting(jitter_scale).get(shown_settings(s)); };
  return action;
}

void switch_sharpening(DemoState& state) {
  const TaaMode* row = find_taa_mode(shown_name(state));
  const float of_row = row != nullptr && row->settings.sharpen > 0 ? row->settings.sharpen : usual_sharpening;
  const bool on = state.modes[state.mode].taa.sharpen > 0;
  change_setting(state, find_setting(sharpen), on ? 0 : of_row);
}

std::string sharpening_present(const DemoState& state) {
  return state.modes[state.mode].taa.sharpen > 0 ? find_setting(sharpen).get(shown_settings(state)) : "off";
}

std::string nothing_moves(const DemoState& state) {
  return state.rig == rest_rig ? "nothing moves in the rig '" + state.rig + "'" : std::string{};
}

std::string no_history(const DemoState& state) {
  const bool keeps = std::ranges::any_of(
      modes_seen(state), [&](size_t place) { return state.modes[place].taa.policy.needs_history(); });
  return keeps ? "" : shown_name(state) + " keeps none";
}

std::string dropped(const DemoState& state) { return state.requests.drop_history ? "dropped" : ""; }

std::string not_paused(const DemoState& state) { return state.paused ? "" : "nothing is paused"; }

std::string as_the_rig(const DemoState& state) {
  return state.camera == CameraOffset{} ? "it is where the rig has it" : "";
}

std::string camera_present(const DemoState& state) {
  return state.camera == CameraOffset{} ? "the rig's" : "moved";
}

std::string no_magnifier(const DemoState& state) { return state.magnifier.shown ? "" : "it is not shown"; }

std::string nothing_compared(const DemoState& state) {
  if (state.arrangement != Arrangement::single) return "they are all shown";
  return state.compared.empty() ? "nothing is compared" : "";
}

std::string flicker_present(const DemoState& state) { return state.modes[state.compared.front()].name; }

void show_next_rig(DemoState& state) {
  const std::span<const Rig> all = rigs();
  const auto now = std::ranges::find(all, state.rig, &Rig::name);
  state.rig = all[size_t(now - all.begin() + 1) % all.size()].name;
}

std::string as_many_as_can_be(const DemoState& state) {
  return state.bookmarks.size() < most_bookmarks ? "" : std::to_string(most_bookmarks) + " are the most";
}

std::string none_kept(const DemoState& state) { return state.bookmarks.empty() ? "none is kept" : ""; }

std::string none_gone_to(const DemoState& state) {
  return state.bookmark ? "" : state.bookmarks.empty() ? "none is kept" : "none is shown: go to one";
}

size_t next_bookmark(const DemoState& state) {
  return state.bookmark ? (*state.bookmark + 1) % state.bookmarks.size() : 0;
}

std::string bookmark_present(const DemoState& state) {
  const std::string of = " of " + std::to_string(state.bookmarks.size());
  return state.bookmark ? std::to_string(*state.bookmark + 1) + of : "none" + of;
}

std::string replaying(const DemoState& state) { return state.replayed ? "a replay goes on" : ""; }

std::string nothing_to_replay(const DemoState& state) {
  if (state.recorded) return "a recording goes on";
  return state.path_file.empty() ? "nothing was recorded" : "";
}

/// Begins or ends with the next frame.
template <auto count, auto asked> std::string path_present(const DemoState& state) {
  const std::optional<uint64_t>& frames = state.*count;
  if (state.requests.*asked) return frames ? "ends" : "begins";
  return frames ? std::to_string(*frames) + " frames" : "off";
}

template <auto member> void request(DemoState& state) { state.requests.*member = true; }

// The table's rows that keep a history, of which the first ten have a digit each.
std::vector<std::string_view> numbered_modes() {
  std::vector<std::string_view> names;
  for (const TaaMode& row : taa_modes())
    if (row.settings.policy.needs_history() && names.size() < numbered) names.push_back(row.name);
  return names;
}

std::string nothing_picked(const DemoState& state) {
  return state.picked ? "" : "none is picked: click on one";
}

template <size_t number> void show_numbered(DemoState& state) {
  static const std::vector<std::string_view> names = numbered_modes();
  show_mode(state, place_of_mode(state, names[number]));
}

template <size_t... number> void add_numbered(std::vector<Action>& rows, std::index_sequence<number...>) {
  constexpr std::array<void (*)(DemoState&), numbered> shows = {show_numbered<number>...};
  const std::vector<std::string_view> names = numbered_modes();
  for (size_t i = 0; i < names.size(); ++i)
    rows.push_back({.name = "mode",
                    .key = GLFW_KEY_0 + int((i + 1) % numbered), // 1 to 9, and 0 to the right of them
                    .what = "Show " + std::string(names[i]),
                    .apply = shows[i],
                    .present = shown_name});
}

// name, key, Shift, button, what, what it does, why not, its present state
// clang-format off
/// The controls of the GDK sample, on its keys and buttons.
std::vector<Action> rows_of_gdk_sample() {
  return {
    {"TAA", GLFW_KEY_ENTER, false, GLFW_GAMEPAD_BUTTON_A, "TAA on or off", switch_taa, says_nothing, taa_present},
    cycles<dilation, 1>({"dilation", GLFW_KEY_Z, false, GLFW_GAMEPAD_BUTTON_B, "Next dilation: whose motion counts"}),
    cycles<rectify, 1>({"rectification", GLFW_KEY_X, false, GLFW_GAMEPAD_BUTTON_X, "Next rectification (colour clamp)"}),
    cycles<jitter, 1>({"jitter", GLFW_KEY_C, false, GLFW_GAMEPAD_BUTTON_Y, "Next jitter sequence"}),
    cycles<history, 1>({"history filter", GLFW_KEY_R, false, GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, "Next filter of the history"}),
    cycles<history, -1>({"history filter", GLFW_KEY_F, false, GLFW_GAMEPAD_BUTTON_DPAD_LEFT, "Previous filter of the history"}),
    {"sharpening", GLFW_KEY_SPACE, false, GLFW_GAMEPAD_BUTTON_START, "Sharpening on or off", switch_sharpening, says_nothing, sharpening_present},
    jitter_scales<1>({"jitter scale", GLFW_KEY_T, false, GLFW_GAMEPAD_BUTTON_DPAD_UP, "Jitter by a tenth of a pixel more"}),
    jitter_scales<-1>({"jitter scale", GLFW_KEY_G, false, GLFW_GAMEPAD_BUTTON_DPAD_DOWN, "Jitter by a tenth of a pixel less"}),
    toggles<&DemoState::moving>({"movement", GLFW_KEY_TAB, false, GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER, "Let everything move, or rest", nullptr, nothing_moves}),
    toggles<&DemoState::magnifier, &Magnifier::shown>({"magnifier", GLFW_KEY_V, false, GLFW_GAMEPAD_BUTTON_LEFT_BUMPER, "Show or hide the magnifier"}),
    {"leave", GLFW_KEY_ESCAPE, false, GLFW_GAMEPAD_BUTTON_BACK, "Leave", request<&DemoRequests::leave>},
  };
}

std::vector<Action> rows_beyond_it() {
  return {
    {"mode", GLFW_KEY_LEFT_BRACKET, false, no_button, "Previous mode", show_neighbour<-1>, says_nothing, shown_name},
    {"mode", GLFW_KEY_RIGHT_BRACKET, false, no_button, "Next mode", show_neighbour<1>, says_nothing, shown_name},
    {"comparison", GLFW_KEY_B, false, no_button, "Compare two modes, or see one", switch_comparison, says_nothing, comparison_present},
    {"arrangement", GLFW_KEY_B, true, no_button, "Next way to compare: bar, grid, difference, FLIP", show_next_arrangement, says_nothing, comparison_present},
    {"compared", GLFW_KEY_EQUAL, false, no_button, "One mode more in a grid", compare_one_more, no_room_for_one_more, compared_present},
    {"compared", GLFW_KEY_MINUS, false, no_button, "One mode less in a grid", compare_one_less, no_one_less, compared_present},
    {"settings", GLFW_KEY_DELETE, false, no_button, "The mode as its row of the table has it", reset_mode, as_its_row, shown_name},
    {"everything", GLFW_KEY_DELETE, true, no_button, "Everything but the scene as in the first run", reset_all, is_as_at_first, says_nothing},
    cycles<view, 1>({"view", GLFW_KEY_N, false, no_button, "Next view in place of the picture"}),
    cycles<view, -1>({"view", GLFW_KEY_N, true, no_button, "Previous view"}),
    toggles<&DemoState::paused>({"pause", GLFW_KEY_P, false, no_button, "Pause, or go on"}),
    {"one frame", GLFW_KEY_PERIOD, false, no_button, "One frame more, while paused", request<&DemoRequests::step>, not_paused},
    {"history", GLFW_KEY_BACKSPACE, false, no_button, "Drop the history", request<&DemoRequests::drop_history>, no_history, dropped},
    {"flicker", GLFW_KEY_K, false, no_button, "Held: the compared mode in its place", [](DemoState&) {}, nothing_compared, flicker_present},
    toggles<&DemoState::magnifier_follows>({"magnifier at the mouse", GLFW_KEY_V, true, no_button, "Let the magnifier follow the mouse", nullptr, no_magnifier}),
    {"pixel", GLFW_KEY_I, false, no_button, "Ask no more about the pixel that was clicked on", [](DemoState& s) { s.picked.reset(); }, nothing_picked, [](const DemoState& s) { return std::string(s.picked ? "picked" : "none"); }},
    {"rig", GLFW_KEY_L, false, no_button, "Next rig: how car and camera move", show_next_rig, says_nothing, [](const DemoState& s) { return s.rig; }},
    {"camera", GLFW_KEY_HOME, false, no_button, "The rig's camera again", [](DemoState& s) { s.camera = {}; }, as_the_rig, camera_present},
    {"bookmark", GLFW_KEY_M, false, no_button, "Keep this view as a bookmark", keep_bookmark, as_many_as_can_be, bookmark_present},
    {"bookmark", GLFW_KEY_M, true, no_button, "Forget the bookmark that is shown", [](DemoState& s) { forget_bookmark(s, *s.bookmark); }, none_gone_to, bookmark_present},
    {"bookmark", GLFW_KEY_J, false, no_button, "Next bookmark: the same view again", [](DemoState& s) { go_to_bookmark(s, next_bookmark(s)); }, none_kept, bookmark_present},
    {"bookmark's camera", GLFW_KEY_J, true, no_button, "Next bookmark's camera, while the rig goes on", [](DemoState& s) { look_as_bookmark(s, next_bookmark(s)); }, none_kept, bookmark_present},
    {"recording", GLFW_KEY_O, false, no_button, "Record the path, or end the recording", request<&DemoRequests::record>, replaying, path_present<&DemoState::recorded, &DemoRequests::record>},
    {"replay", GLFW_KEY_O, true, no_button, "Replay the last recorded path, or stop it", request<&DemoRequests::replay>, nothing_to_replay, path_present<&DemoState::replayed, &DemoRequests::replay>},
    {"full screen", GLFW_KEY_F11, false, no_button, "Full screen, or a window", request<&DemoRequests::full_screen>},
    {"screenshot", GLFW_KEY_F12, false, no_button, "Take a picture of what is shown", request<&DemoRequests::screenshot>},
    toggles<&DemoState::keys>({"keys", GLFW_KEY_H, false, no_button, "Show or hide what the keys do"}),
    toggles<&DemoState::hidden>({"only the picture", GLFW_KEY_U, false, no_button, "Hide everything else, or show it"}),
  };
}
// clang-format on

std::vector<Action> table() {
  std::vector<Action> rows = rows_of_gdk_sample();
  add_numbered(rows, std::make_index_sequence<numbered>());
  std::ranges::move(rows_beyond_it(), std::back_inserter(rows));
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
