// A path through the demo: all that decides the pictures of its frames, so that the window and a run without
// one draw them alike, to the bit.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/command_line.h"
#include "app/demo/demo_state.h"
#include "app/rigs.h"

namespace unghost {

/// What one frame is drawn from, beside what is set.
struct Moment {
  std::string rig = "drive";
  uint64_t rig_frame = 0; // the rig's time
  CameraOffset camera;
  uint64_t index = 0; // chooses the jitter
  PictureSize size;
  bool cut = false; // nothing of before may be used

  bool operator==(const Moment&) const = default;
};

/// `fit`: to the scene, with the frame's settings.
Instant instant_of(const Moment& moment, const RigContext& fit);
/// `before`: of the frame before; it is not read at a cut.
FrameInput frame_input(const Moment& moment, const Instant& now, const Instant& before,
                       const Settings& settings, std::vector<ModeRun> modes);

/// What is set.
struct Look {
  Settings settings;          // what all modes share; its taa is not read
  std::vector<ModeRun> modes; // every row of the table, as it has been changed
  std::vector<size_t> shown;  // of `modes`, from one to four; none twice
  Arrangement arrangement = Arrangement::single;

  bool operator==(const Look&) const = default;
};

/// That of the demo without any file; recordings begin from it.
Look usual_look();
/// `shown`: of the state's modes.
Look look_of(const DemoState& state, std::vector<size_t> shown);
void take_look(DemoState& state, const Look& look);
/// As the look has them, in the order in which they are shown.
std::vector<ModeRun> shown_modes(const Look& look);
/// Whether no scene has to be loaded between the two: a vehicle's speed is the rig's.
bool same_stage(StageSettings a, const StageSettings& b);

struct Recording {
  struct Frame {
    Moment moment;
    size_t look = 0; // of `looks`
  };

  std::string scene = own_scene;
  uint64_t seed = 1;
  std::vector<Look> looks;   // all of one stage
  std::vector<Frame> frames; // at least one; the first is a cut
};

/// Frame `index` of it: a pure function. `fit`: to its scene.
FrameInput frame_input(const Recording& recording, const RigContext& fit, size_t index);
/// All of it under these modes, set as they were. Throws SettingError with the nearest name.
void show_only(Recording& recording, std::span<const std::string> modes);

} // namespace unghost
