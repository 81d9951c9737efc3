#include "app/measure/supersampling.h"

#include <algorithm>
#include <cmath>

#include "app/measure/display.h"
#include "renderer/view.h"

namespace unghost {
namespace {

// Far along the same sequence: no mode's jitter and none of the fewer samples are among the reference's.
constexpr uint64_t line_begins = 1, reference_begins = 4096;

/// The mean of linear frames so far.
class Mean {
public:
  void add(const FloatImage& frame) {
    if (sum_.empty())
      sum_.resize(frame.values.size()), shape_ = {frame.width, frame.height, frame.channels, {}};
    for (size_t i = 0; i < sum_.size(); ++i) sum_[i] += double(frame.values[i]);
    ++count_;
  }
  Image displayed(float exposure_ev) const {
    FloatImage linear = shape_;
    linear.values.reserve(sum_.size());
    for (const double sum : sum_) linear.values.push_back(float(sum / double(count_)));
    return displayed_8_bit(linear, exposure_ev);
  }

  uint32_t count() const { return count_; }

private:
  std::vector<double> sum_;
  FloatImage shape_;
  uint32_t count_ = 0;
};

FloatImage draw_sample(const Film& film, uint32_t frame, glm::dvec2 offset_px) {
  FrameInput input = at_rest(film, frame);
  input.modes = {{.name = "sample", .taa = {}}};
  input.jitter_px = offset_px;
  input.wanted = {{Output::resolved}};
  return std::move(film.draw(input).delivered.front().image);
}

float exposure_of(const Film& film, uint32_t frame) { return film.at(frame).settings.light.exposure_ev; }

/// Pairs of R2's points and their mirror images, so that the mean of any even number is the pixel's middle.
glm::dvec2 mirrored(uint64_t sample, uint64_t begin) {
  const glm::dvec2 point = r2_sequence(begin + sample / 2);
  return sample % 2 == 0 ? point : -point;
}

} // namespace

std::vector<Image> progressive_means(const Film& film, uint32_t frame, std::span<const uint32_t> samples) {
  Mean mean;
  std::vector<Image> means;
  for (const uint32_t count : samples) {
    if (count == 1) {
      Mean middle;
      middle.add(draw_sample(film, frame, glm::dvec2(0)));
      means.push_back(middle.displayed(exposure_of(film, frame)));
      continue;
    }
    for (uint32_t sample = mean.count(); sample < count; ++sample)
      mean.add(draw_sample(film, frame, mirrored(sample, line_begins)));
    means.push_back(mean.displayed(exposure_of(film, frame)));
  }
  return means;
}

Image supersampled_reference(const Film& film, uint32_t frame, uint32_t samples,
                             const ReferenceCache& cache) {
  if (same_moment(film, frame, 0)) frame = 0; // one reference for a world at rest
  if (cache.find)
    if (std::optional<Image> found = cache.find(frame, samples)) return std::move(*found);
  Mean mean;
  for (uint32_t sample = 0; sample < samples; ++sample)
    mean.add(draw_sample(film, frame, mirrored(sample, reference_begins)));
  Image reference = mean.displayed(exposure_of(film, frame));
  if (cache.keep) cache.keep(frame, samples, reference);
  return reference;
}

SupersampledFrame supersampled(const Film& film, uint32_t frame, uint32_t samples,
                               const ReferenceCache& cache) {
  return {.reference = supersampled_reference(film, frame, samples, cache),
          .fewer = progressive_means(film, frame, supersampling_steps)};
}

} // namespace unghost
