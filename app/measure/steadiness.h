// For how many frames each pixel has shown the same surface in the same light: the exact test that only
// measurements run, since it needs last frame's depth, objects and shadows.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/frame_input.h"

namespace unghost {

/// What a pixel showed last changed because of this.
enum class Change : uint8_t { start, edge, surface, shadow };

struct PixelHistory {
  uint8_t steady_frames = 0; // since the change; 255 and more are 255
  Change change = Change::start;
};

/// One frame without jitter, all of one size.
struct Surfaces {
  FloatImage depth, previous_depth; // metres, this frame's and of the same point last frame
  FloatImage motion;                // pixels, previous minus current
  FloatImage object, sun_visibility;
};

class Steadiness {
public:
  /// Reprojects each pixel to last frame's nearest one. Steady: inside the frame, the same object, the
  /// expected depth within 1% of the range of the 3x3 pixels there (their range allows for slopes), the same
  /// sun visibility within 0.05 of the range of the 2x2 around the exact place. Sky that was sky is steady.
  void advance(Surfaces now);
  /// Row by row from the top; empty before the first frame.
  std::span<const PixelHistory> pixels() const { return pixels_; }

private:
  PixelHistory next(const Surfaces& now, int x, int y) const;

  Surfaces last_;
  std::vector<PixelHistory> pixels_;
};

} // namespace unghost
