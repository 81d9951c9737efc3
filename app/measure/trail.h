// Trail: the share of a ghost that a resolve leaves, taken where the history is truly wrong.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "app/measure/steadiness.h"

namespace unghost {

/// Pixels count while their surface or their light changed within so many frames.
constexpr int trail_frames = 8;

/// 0: nothing of the ghost is left; 1: all of it. Empty where nothing changed.
struct Trail {
  std::optional<double> whole, surface, shadow;
};

/// One frame's images: linear rgb, one size, jitter off.
struct TrailImages {
  const FloatImage& aliased;               // no history
  const FloatImage& accumulated;           // history never rejected but off-screen, Catmull-Rom
  std::vector<const FloatImage*> resolved; // of each mode
};

class TrailMeter {
public:
  struct Sums {
    double remaining = 0, all = 0;
  };

  TrailMeter(size_t modes, float exposure_ev) : modes_(modes), exposure_ev_(exposure_ev) {}

  /// With A the aliased, H the accumulated, R a mode's resolved image and B the 3x3 Gaussian of A, all as
  /// displayed and then smoothed by a 5x5 Gaussian of sigma 1.5: adds max(0, max(0, <R-A, H-A>) - max(0,
  /// <B-A, H-A>)) and |H-A|^2 of the pixels that count. `pixels` as many as the images have.
  void add(std::span<const PixelHistory> pixels, const TrailImages& images);
  Trail trail_of(size_t mode) const;
  /// Surfaces and shadows together, a frame each.
  const std::vector<Sums>& frames_of(size_t mode) const { return modes_.at(mode).frames; }

private:
  struct ModeSums {
    Sums surface, shadow;
    std::vector<Sums> frames;
  };

  std::vector<ModeSums> modes_;
  float exposure_ev_;
};

} // namespace unghost
