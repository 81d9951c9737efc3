// What each mode adds to a frame, from timestamps of the device. The modes take turns within each round,
// beside their naive resolves and a full-screen copy, so that a slow minute slows all of them.
#pragma once

#include <vector>

#include "app/measure/film.h"

namespace unghost {

/// A number a round each; empty where there is nothing to compare with.
struct ModeTimes {
  std::vector<double> added_ms, resolve_ms; // of all passes that `off` has not, and of the resolve alone
  std::vector<double> added_over_copy;      // of all of it
  std::vector<double> over_copy, over_naive, over_no_rejection; // of the resolve
  std::vector<double> over_plain_store;                         // of the resolve, where it was asked for
};
struct RunTimes {
  std::vector<ModeTimes> modes;
  std::vector<double> copy_ms, motion_ms;
  std::vector<double> geometry_ms; // what each sample of a pixel would be drawn with: G-buffer and light
};

/// Draws `rounds` frames of the rig after some that warm up. Naive resolves and rows without their rejection
/// are drawn in the first of them only, as are rows that leave their store to the device, for `stores`. No
/// mode may have a jitter.
RunTimes time_modes(const Film& film, const std::vector<ModeRun>& modes, uint32_t rounds,
                    bool stores = false);
/// Times of all passes of a frame, ms, medians of rounds: of one frame with all modes, and of a frame of each
/// alone, in which a mode pays for all that is made for it. Each is the second of two frames, so that
/// histories are there.
struct Sharing {
  double together_ms = 0;
  std::vector<double> alone_ms; // as the modes
};
Sharing time_sharing(const Film& film, const std::vector<ModeRun>& modes, uint32_t rounds);

/// What all its frames take, as work_of(FrameInput) counts.
double timed_work(const std::vector<ModeRun>& modes, uint32_t rounds, bool stores = false);

} // namespace unghost
