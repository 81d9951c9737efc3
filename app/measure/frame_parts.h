// What a frame is made of, and what each thing that it was made without would have cost: the frame itself,
// one with everything kept and one with everything but each such thing take turns, so that a slow minute
// slows all of them.
#pragma once

#include <vector>

#include "app/measure/film.h"

namespace unghost {

struct Saving {
  LeftOut thing;
  int64_t bytes = 0;      // of images; those of a pass may come to lie in memory that another one left
  std::vector<double> ms; // a round each
};

struct FrameParts {
  FrameResult frame, everything;            // one of the frames each; times are those below
  std::vector<std::vector<double>> pass_ms; // of the frame's passes, a round each
  std::vector<double> frame_ms, everything_ms;
  std::vector<Saving> savings;
};

/// Draws the frames up to `frame`, and then that one `rounds` times in each way.
FrameParts take_apart(const Film& film, const ModeRun& mode, uint32_t frame, uint32_t rounds);

} // namespace unghost
