// Frames of many samples a pixel: what a resolve should have come to.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/measure/film.h"

namespace unghost {

/// The world at rest at one instant, in linear light the mean of jittered frames, as displayed in 8 bits.
struct SupersampledFrame {
  Image reference;
  std::vector<Image>
      fewer; // means of as many samples as supersampling_steps say, none of them the reference's
};
constexpr uint32_t supersampling_steps[] = {1, 2, 4, 8, 16};

/// References that were drawn before; either may be empty.
struct ReferenceCache {
  std::function<std::optional<Image>(uint32_t frame, uint32_t samples)> find;
  std::function<void(uint32_t frame, uint32_t samples, const Image&)> keep;
};

/// The mean of `samples`, drawn where it cannot be found.
Image supersampled_reference(const Film& film, uint32_t frame, uint32_t samples, const ReferenceCache& cache);
/// That and the means of fewer.
SupersampledFrame supersampled(const Film& film, uint32_t frame, uint32_t samples,
                               const ReferenceCache& cache);

/// The mean of n samples for each n, as displayed; 1 is the pixel's middle. Rising; all but 1 are even.
std::vector<Image> progressive_means(const Film& film, uint32_t frame, std::span<const uint32_t> samples);

} // namespace unghost
