// Small separable filters; what lies beyond the edge is the nearest pixel of the edge.
#pragma once

#include <span>

#include "renderer/frame_input.h"

namespace unghost {

/// The square filter whose rows and columns are `weights`, an odd number of them.
FloatImage smoothed(const FloatImage& image, std::span<const float> weights);

/// 1 2 1 / 2 4 2 / 1 2 1, over 16: what a resolve shows where it rejects its history.
FloatImage gaussian_3x3(const FloatImage& image);
/// 5x5, sigma 1.5: a ghost is wider than the texture that it lies on.
FloatImage gaussian_5x5(const FloatImage& image);

} // namespace unghost
