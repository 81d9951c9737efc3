// Flicker: how much the error of a resolve changes along the motion, from one frame to the next.
#pragma once

#include <optional>
#include <span>

#include "app/measure/steadiness.h"

namespace unghost {

/// What a resolve shows beyond what it should: three channels, -1 to 1. Both pictures are 8-bit and of one
/// size.
FloatImage excess(const Image& resolved, const Image& reference);

/// The mean over pixels and channels of |now - before|, `before` (last frame's) taken bilinearly from where
/// `motion` (pixels, previous minus current) says that each pixel was. Pixels count whose surface both frames
/// show; nothing where there is none.
std::optional<double> flicker_between(const FloatImage& before, const FloatImage& now,
                                      const FloatImage& motion, std::span<const PixelHistory> pixels);

} // namespace unghost
