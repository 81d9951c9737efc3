// Where the protocols get their frames from: one scene, rig and size on one device.
#pragma once

#include <functional>

#include "renderer/frame_input.h"

namespace unghost {

struct Film {
  /// The rig's frame: what lies between it and the one before, without modes and with nothing wanted. Frame 0
  /// is a cut.
  std::function<FrameInput(uint32_t frame)> at;
  /// Draws; may throw what ends a run.
  std::function<FrameResult(const FrameInput&)> draw;
  bool animated = true; // the scene has animations of its own
};

/// What drawing it and judging what is wanted of it takes, in frames of one mode; roughly.
double work_of(const FrameInput& input);

/// What came of the first Wanted of that kind and mode. It must have been wanted.
Delivered& delivered(const std::vector<Wanted>& wanted, FrameResult& result, Output what, size_t mode = 0);

/// Whether both frames show the world at the same moment, as where nothing moves.
bool same_moment(const Film& film, uint32_t a, uint32_t b);

/// The world stands still at that frame; a cut.
FrameInput at_rest(const Film& film, uint32_t frame);

} // namespace unghost
