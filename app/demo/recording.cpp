#include "app/demo/recording.h"

#include <utility>

namespace unghost {
namespace {

RigContext context_of(const Recording& recording, RigContext fit, const Settings& settings) {
  fit.seed = recording.seed;
  fit.stage = settings.stage;
  fit.light = settings.light;
  return fit;
}

Instant instant_in(const Recording& recording, const RigContext& fit, size_t index) {
  const Recording::Frame& frame = recording.frames[index];
  return instant_of(frame.moment, context_of(recording, fit, recording.looks[frame.look].settings));
}

} // namespace

Instant instant_of(const Moment& moment, const RigContext& fit) {
  return with_camera(moment.camera,
                     find_rig(moment.rig)->at(fit, double(moment.rig_frame) * seconds_per_frame));
}

FrameInput frame_input(const Moment& moment, const Instant& now, const Instant& before,
                       const Settings& settings, std::vector<ModeRun> modes) {
  FrameInput input;
  input.now = now;
  input.before = moment.cut ? now : before;
  input.index = moment.index;
  input.cut = moment.cut;
  input.width = moment.size.width;
  input.height = moment.size.height;
  input.settings = settings;
  input.modes = std::move(modes);
  return input;
}

Look usual_look() {
  const DemoState usual = default_demo_state();
  return look_of(usual, modes_seen(usual));
}

Look look_of(const DemoState& state, std::vector<size_t> shown) {
  const Arrangement arrangement = shown.size() > 1 ? state.arrangement : Arrangement::single;
  return {.settings = state.settings,
          .modes = state.modes,
          .shown = std::move(shown),
          .arrangement = arrangement};
}

void take_look(DemoState& state, const Look& look) {
  state.settings = look.settings;
  state.modes = look.modes;
  show_mode(state, look.shown.front());
  state.arrangement = look.arrangement;
  if (look.shown.size() > 1) state.compared.assign(look.shown.begin() + 1, look.shown.end());
}

std::vector<ModeRun> shown_modes(const Look& look) {
  std::vector<ModeRun> modes;
  for (const size_t mode : look.shown) modes.push_back(look.modes[mode]);
  return modes;
}

bool same_stage(StageSettings a, const StageSettings& b) {
  a.speed = b.speed;
  return a == b;
}

FrameInput frame_input(const Recording& recording, const RigContext& fit, size_t index) {
  const Recording::Frame& frame = recording.frames[index];
  const Look& look = recording.looks[frame.look];
  return frame_input(frame.moment, instant_in(recording, fit, index),
                     instant_in(recording, fit, index == 0 ? 0 : index - 1), look.settings,
                     shown_modes(look));
}

void show_only(Recording& recording, std::span<const std::string> modes) {
  const DemoState rows = default_demo_state();
  std::vector<size_t> shown;
  for (const std::string& name : modes) shown.push_back(place_of_mode(rows, name));
  for (Look& look : recording.looks) {
    look.shown = shown;
    look.arrangement = shown.size() > 1 ? Arrangement::grid : Arrangement::single;
  }
}

} // namespace unghost
