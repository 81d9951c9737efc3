// When the next frame need not be drawn: nothing differs from the frame before but the jitter, and the
// history has settled.
#pragma once

#include <optional>
#include <string>

#include "renderer/frame_input.h"

namespace unghost {

/// After so many frames of a world at rest, from a cut on, less than half of what a display can show (1/512)
/// is left of the first of them, and the jitter has gone through its points a whole number of times. From
/// then on the pictures repeat themselves with the jitter to within a step of the display: one that stays in
/// place of the next is one of them, without their flicker. Nothing for a mode that clips its history
/// everywhere: which plane it is clipped by changes with the least difference, and its pictures never repeat
/// themselves.
std::optional<uint32_t> frames_until_settled(const TaaSettings& taa);

/// Told of every frame in turn, it says how many of them have to be drawn.
class Stillness {
public:
  /// Whether anything reads the clock of the scene's own animations.
  explicit Stillness(bool animated) : animated_(animated) {}

  /// How many frames from this one on are to be drawn, if nothing changes; 0: this one may be skipped.
  /// Nothing: all of them.
  std::optional<uint32_t> frames_left(const FrameInput& input);
  /// What of the last frame differs from the one before it, as a sentence goes on: "the camera moves". Empty
  /// where nothing does.
  const std::string& change() const { return change_; }

private:
  std::string change_to(const FrameInput& input) const;

  bool animated_;
  std::optional<FrameInput> last_;
  std::string change_;
  uint32_t at_rest_ = 0; // frames
};

} // namespace unghost
