// What a person does to the demo: keys, gamepad, mouse and dropped files.
#include <algorithm>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/actions.h"
#include "app/demo/demo.h"

namespace unghost {
namespace {

constexpr double longest_step_seconds = 0.1, beside_bar = 0.03; // of the width
constexpr double orbit_a_height = 3, look_a_second = 1.5;       // radians
constexpr double magnifier_a_second = 0.5;                      // of the picture

} // namespace

void Demo::pick(const WindowEvents::Click& click) {
  if (gui_.has_mouse()) return;
  const PicturePlace where = place();
  const glm::dvec2 at = click.at - where.at;
  const auto point = picture_point(where.screen, shown().size(), at.x, at.y);
  if (!point) return;
  state_.picked.reset();
  if (!click.shift) state_.picked = {.mode = point->mode, .at = point->at};
  say_event("mouse", "pick");
}

/// A split's bar, or the camera.
void Demo::drag(const WindowEvents& events, const WindowHeld& held, CameraInput& input) {
  const PicturePlace where = place();
  const auto share = [&](glm::dvec2 mouse) { return (mouse.x - where.at.x) / where.screen.width; };
  const glm::dvec2 moved = (held.mouse - mouse_) / double(where.screen.height) * glm::dvec2(-1, 1);
  if (!gui_.has_mouse()) {
    if (events.left_pressed && state_.arrangement == Arrangement::split)
      drags_bar_ = std::abs(share(*events.left_pressed) - state_.split) < beside_bar;
    if (held.left && drags_bar_)
      state_.split = std::clamp(share(held.mouse), 0.02, 0.98);
    else if (held.left && was_held_)
      input.orbit = moved * orbit_a_height;
    if (held.right || held.middle) input.pan = moved;
    input.zoom = events.scroll;
  }
  if (!held.left) drags_bar_ = false;
  was_held_ = held.left;
  mouse_ = held.mouse;
}

void Demo::move_magnifier(const WindowHeld& held, double seconds) {
  const PicturePlace where = place();
  glm::dvec2& centre = state_.magnifier.centre;
  centre += held.right_stick * seconds * magnifier_a_second;
  if (state_.magnifier_follows)
    centre = (held.mouse - where.at) / glm::dvec2(where.screen.width, where.screen.height);
  centre = glm::clamp(centre, glm::dvec2(0), glm::dvec2(1));
}

void Demo::steer(const WindowEvents& events, const WindowHeld& held) {
  CameraInput input{.fast = held.shift ? 4.0 : 1.0};
  drag(events, held, input);
  if (!gui_.has_keys() && !held.control) input.fly = held.fly;
  const double last_frame_seconds = facts_.frame_ms.empty() ? 0 : double(facts_.frame_ms.back()) / 1000;
  const double seconds = std::min(last_frame_seconds, longest_step_seconds);
  input.fly += glm::dvec3(held.left_stick.x, 0, -held.left_stick.y);
  if (state_.magnifier.shown)
    move_magnifier(held, seconds);
  else
    input.orbit -= held.right_stick * seconds * look_a_second * glm::dvec2(1, -1);
  const Instant rig = instant_of({.rig = state_.rig, .rig_frame = state_.rig_frame}, context_);
  unghost::steer(state_.camera, input, rig, seconds);
}

void Demo::react() {
  const WindowEvents events = window_.events(0);
  const auto act = [&](const char* event, const Action* action) {
    if (action == nullptr) return;
    perform(*action, state_);
    say_event(event, std::string(action->name));
  };
  if (!gui_.has_keys())
    for (const WindowEvents::Press& press : events.pressed)
      if (!press.control) act("key", action_for_key(press.key, press.shift));
  for (const int button : events.buttons) act("button", action_for_button(button));
  for (const std::string& sentence : events.gamepads) {
    state_.message = sentence;
    say_event("gamepad", sentence);
  }
  if (!events.dropped.empty()) ask_for_scene(scene_among(events.dropped), "drop");
  const Action* flicker = action_for_key(GLFW_KEY_K, false);
  state_.flicker = window_.holds(GLFW_KEY_K) && flicker->why_not(state_).empty();
  for (const WindowEvents::Click& click : events.clicks) pick(click);
  steer(events, window_.held());
  if (window_.closed()) state_.requests.leave = true;
}

} // namespace unghost
