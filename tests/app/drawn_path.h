// A path as the demo records it, without a device.
#pragma once

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "app/demo/recording_file.h"

namespace unghost {

/// What was drawn, as the demo draws it: each frame from the instant of the one before.
struct Drawn {
  Recorder recorder{"my car.glb", 7};
  DemoState state = default_demo_state();
  RigContext fit{.seed = 7, .track_radius = 120, .vehicle = {{-1, 0, -2}, {1, 1.5f, 2}}};
  std::optional<Instant> last;
  std::vector<FrameInput> inputs;
  std::vector<Moment> moments;

  void draw(Moment moment) {
    moment.index = 1000 + inputs.size();
    moment.cut |= inputs.empty();
    fit.stage = state.settings.stage, fit.light = state.settings.light;
    std::vector<ModeRun> modes;
    for (const size_t mode : modes_seen(state)) modes.push_back(state.modes[mode]);
    const Instant now = instant_of(moment, fit);
    inputs.push_back(frame_input(moment, now, last.value_or(now), state.settings, modes));
    moments.push_back(moment);
    recorder.add(moment, look_of(state, modes_seen(state)));
    last = now;
  }
};

/// Every way in which a frame can be another than the one before.
inline Drawn drawn_path() {
  Drawn drawn;
  Moment moment{.rig = "pass", .rig_frame = 500, .size = {320, 180}};
  const auto on = [&] { ++moment.rig_frame, drawn.draw(moment); };
  drawn.draw(moment);
  on();
  show_mode(drawn.state, place_of_mode(drawn.state, "blend"));
  drawn.state.modes[drawn.state.mode].taa.alpha = 0.1f + 1e-8f;
  on();
  moment.camera = {.yaw = 1.0 / 3, .pitch = -0.1, .distance = std::nextafter(0.2, 1), .pan = {1e-300, 2, 3}};
  on();
  drawn.state.settings.stage.speed = 0.7f; // the rig is then elsewhere at once
  drawn.state.settings.light.sun_azimuth_deg = 12.34f;
  drawn.state.settings.view = View::motion;
  on();
  const glm::dquat turn = glm::normalize(glm::dquat(0.1, 0.7, -0.3, 0.2));
  moment.camera.flown = {.eye = {std::numbers::pi, -0.0, 1e5}, .camera = turn};
  drawn.state.arrangement = Arrangement::grid;
  drawn.state.compared = {place_of_mode(drawn.state, "dop32"), place_of_mode(drawn.state, "off")};
  moment.size = {160, 90};
  on();
  drawn.draw(moment); // nothing moves
  moment.rig = "rotate", moment.rig_frame = 3, moment.cut = true;
  drawn.draw(moment);
  moment.cut = false, moment.camera = {}, drawn.state.arrangement = Arrangement::single;
  on();
  return drawn;
}

inline void expect_same(const FrameInput& a, const FrameInput& b) {
  EXPECT_EQ(a.now, b.now);
  EXPECT_EQ(a.before, b.before);
  EXPECT_EQ(std::tuple(a.index, a.cut, a.width, a.height), std::tuple(b.index, b.cut, b.width, b.height));
  EXPECT_EQ(a.settings, b.settings);
  EXPECT_EQ(a.modes, b.modes);
}

} // namespace unghost
