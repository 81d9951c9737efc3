#include "app/measure/supersampling.h"

#include <algorithm>
#include <cmath>

#include "app/measure/display.h"
#include "renderer/view.h"

namespace unghost {
namespace {

// Far along the same sequence, so that no mode's jitter and none of the fewer samples are among them.
constexpr uint64_t reference_begins = 4096;

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
    for (const double sum : sum_) linear.values.push_back(float(sum / count_));
    return displayed_8_bit(linear, exposure_ev);
  }

private:
  std::vector<double> sum_;
  FloatImage shape_;
  double count_ = 0;
};

FloatImage draw_sample(const Film& film, uint32_t frame, uint64_t sample) {
  FrameInput input = at_rest(film, frame);
  input.modes = {{.name = "sample", .taa = {}}};
  input.jitter_px = r2_sequence(sample);
  input.wanted = {{Output::resolved}};
  return std::move(film.draw(input).delivered.front().image);
}

} // namespace

std::vector<Image> progressive_means(const Film& film, uint32_t frame, std::span<const uint32_t> samples) {
  const float exposure_ev = film.at(frame).settings.light.exposure_ev;
  Mean mean;
  std::vector<Image> means;
  for (uint32_t sample = 0; means.size() < samples.size(); ++sample) {
    mean.add(draw_sample(film, frame, sample));
    if (sample + 1 == samples[means.size()]) means.push_back(mean.displayed(exposure_ev));
  }
  return means;
}

Image supersampled_reference(const Film& film, uint32_t frame, uint32_t samples,
                             const ReferenceCache& cache) {
  if (cache.find)
    if (std::optional<Image> found = cache.find(frame, samples)) return std::move(*found);
  Mean mean;
  for (uint32_t sample = 0; sample < samples; ++sample)
    mean.add(draw_sample(film, frame, reference_begins + sample));
  Image reference = mean.displayed(film.at(frame).settings.light.exposure_ev);
  if (cache.keep) cache.keep(frame, samples, reference);
  return reference;
}

SupersampledFrame supersampled(const Film& film, uint32_t frame, uint32_t samples,
                               const ReferenceCache& cache) {
  return {.reference = supersampled_reference(film, frame, samples, cache),
          .fewer = progressive_means(film, frame, supersampling_steps)};
}

} // namespace unghost
