// FLIP: how different two pictures look to somebody who flips between them (Andersson et al. 2020, "FLIP: A
// Difference Evaluator for Alternating Images"; for HDR, Andersson et al. 2021). As NVIDIA's own program,
// version 1.6, to 1e-4 of a mean and 1e-3 of a pixel. The same pictures give the same bits, with whatever
// vectors and however many threads.
#pragma once

#include <span>
#include <utility>

#include "renderer/flip_filters.h"
#include "renderer/frame_input.h"

namespace unghost {

/// Of a monitor `monitor_m` wide with `monitor_px` across, seen from `distance_m`.
double pixels_per_degree(double distance_m, double monitor_px, double monitor_m);

struct FlipOptions {
  double pixels_per_degree = usual_pixels_per_degree;
  unsigned threads = 0; // 0: as many as there are cores
};

/// How many threads such a number asks for.
unsigned threads_of(unsigned threads);

/// 8-bit sRGB as linear RGB; alpha is left out.
FloatImage linear_from_srgb(const Image& picture);

/// All that the metric takes of one picture, a value a pixel in each plane: colours as the eye filters them
/// (CIELab after Hunt's effect), and how strong edges and points are.
struct SeenPicture {
  uint32_t width = 0, height = 0;
  std::vector<float> l, a, b, edge, point;
};
/// Linear RGB as a screen shows it: what is beyond 0 to 1 is clamped.
SeenPicture seen(const FloatImage& linear, const FlipOptions& options = {});
/// 8-bit sRGB; alpha is left out.
SeenPicture seen(const Image& srgb, const FlipOptions& options = {});

/// The error of each pixel, 0 to 1: one channel. Both are of one size, and seen with the same pixels per
/// degree.
FloatImage flip(const SeenPicture& reference, const SeenPicture& test, const FlipOptions& options = {});
/// The mean of those errors, summed in double.
double mean_flip(const SeenPicture& reference, const SeenPicture& test, const FlipOptions& options = {});
/// Of linear RGB, both of one size.
FloatImage flip(const FloatImage& reference, const FloatImage& test, const FlipOptions& options = {});

enum class ToneMapper { aces, hable, reinhard };
inline constexpr std::pair<const char*, ToneMapper> tone_mappers[] = {
    {"aces", ToneMapper::aces}, {"hable", ToneMapper::hable}, {"reinhard", ToneMapper::reinhard}};
/// In stops; the first and the last are taken, too.
struct Exposures {
  double first = 0, last = 0;
  uint32_t count = 2;
};
/// From the brightest pixel just below white to the median as bright as that. A reference whose median is
/// black (which has no last exposure) is taken by the median of what is not black; one that is all black at
/// 0.
Exposures exposures_of(const FloatImage& reference, ToneMapper mapper);

/// One a stop, and two at least.
uint32_t exposures_between(double first, double last);

struct HdrFlip {
  FloatImage error;    // the worst of all exposures
  FloatImage exposure; // which it was, 0 (first) to 1 (last)
};
/// Both are linear and of one size, without bounds.
HdrFlip hdr_flip(const FloatImage& reference, const FloatImage& test, const Exposures& exposures,
                 ToneMapper mapper, const FlipOptions& options = {});

/// Of all errors; the weighted quantiles count each error as much as it is large.
struct FlipSummary {
  double mean = 0, min = 0, max = 0, weighted_first_quartile = 0, weighted_median = 0,
         weighted_third_quartile = 0;
};
FlipSummary summary_of(std::span<const float> errors);

} // namespace unghost
