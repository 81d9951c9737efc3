// The controls of the GDK sample, on its keys and buttons.
#include <algorithm>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/action_rows.h"
#include "app/measure/results.h"

namespace unghost {
namespace {

constexpr char dilation[] = "dilation", rectify[] = "rectify", jitter[] = "jitter", history[] = "history",
               jitter_scale[] = "jitter-scale", sharpen[] = "sharpen";
constexpr float least_jitter = 0.2f, most_jitter = 1, usual_sharpening = 0.5f;

bool taa_is_off(const DemoState& state) { return shown_name(state) == no_taa; }

void switch_taa(DemoState& state) {
  show_mode(state, taa_is_off(state) ? state.shown_before : place_of_mode(state, no_taa));
}

std::string taa_present(const DemoState& state) {
  return taa_is_off(state) ? "off" : "on, " + shown_name(state);
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

} // namespace

// clang-format off
std::vector<Action> sample_rows() {
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
// clang-format on

} // namespace unghost
