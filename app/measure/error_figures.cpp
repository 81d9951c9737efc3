// Error and flicker: frames in motion with jitter, against supersampled frames at the same instants.
#include <algorithm>
#include <numeric>

#include "app/measure/flicker.h"
#include "app/measure/kept_frames.h"
#include "app/measure/measure_parts.h"

namespace unghost {
namespace {

constexpr uint32_t jitter_points = 10; // of R2, that all modes share

/// What is compared with a supersampled frame: a mode, or means of fewer samples.
struct Contender {
  MeasuredMode figures;
  FloatImage last_excess;
};

class Errors {
public:
  Errors(const Measurement& m, Measured& into)
      : m_(m), into_(into), contenders_(m.modes.size() + std::size(supersampling_steps)),
        keeper_(m, "error", true) {}

  /// Before any mode is drawn: other pictures between its frames would end its history.
  void draw_references() {
    std::optional<uint32_t> last;
    for (const uint32_t frame : reference_frames(m_.protocol)) {
      const bool at_rest = last && same_moment(m_.film, *last, frame);
      moves_ = moves_ && !at_rest;
      references_.emplace(frame, at_rest ? references_.at(*last) : drawn(frame));
      last = frame;
    }
  }
  bool wanted(uint32_t frame) const { return references_.contains(frame); }

  void take(uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result) {
    const SupersampledFrame& supersampled = references_.at(frame);
    const SeenPicture reference = seen(supersampled.reference);
    if (asks(m_, Aspect::flicker)) take_surfaces(wanted, result);
    for (size_t mode = 0; mode < m_.modes.size(); ++mode) {
      const Image& picture = delivered(wanted, result, Output::display, mode).picture;
      const double flip = judge(contenders_[mode], picture, supersampled.reference, reference);
      keeper_.offer({.mode = mode,
                     .frame = frame,
                     .flip = flip,
                     .picture = picture,
                     .reference = supersampled.reference});
    }
    for (size_t step = 0; step < std::size(supersampling_steps); ++step)
      judge(contenders_[m_.modes.size() + step], supersampled.fewer[step], supersampled.reference, reference);
    has_last_ = !has_last_; // the first of a pair is the second's last frame
  }

  void finish() {
    for (size_t mode = 0; mode < m_.modes.size(); ++mode)
      for (const auto& [figure, samples] : contenders_[mode].figures.samples)
        into_.rows[mode].samples[figure] = samples;
    for (const char* figure : {"error", "flicker"}) set_means(into_, figure);
    for (size_t step = 0; step < std::size(supersampling_steps); ++step) {
      Supersampled one{.samples = supersampling_steps[step], .figures = {}};
      if (asks(m_, Aspect::shimmer)) one.figures["shimmer"] = 0; // the same samples every frame
      for (const auto& [figure, samples] : contenders_[m_.modes.size() + step].figures.samples)
        one.figures[figure] = mean_of(samples);
      into_.supersampled.push_back(one);
    }
    keeper_.finish(into_);
  }

private:
  SupersampledFrame drawn(uint32_t frame) const {
    return supersampled(m_.film, frame, m_.protocol.samples, m_.references);
  }

  void take_surfaces(const std::vector<Wanted>& wanted, FrameResult& result) {
    motion_ = delivered(wanted, result, Output::motion, m_.modes.size()).image;
    steadiness_.advance(surfaces_of(wanted, result, m_.modes.size()));
  }

  double judge(Contender& contender, const Image& picture, const Image& reference,
               const SeenPicture& seen_reference) {
    const double flip = mean_flip(seen_reference, seen(picture));
    if (asks(m_, Aspect::error)) add_sample(contender.figures, "error", flip);
    if (!asks(m_, Aspect::flicker)) return flip;
    FloatImage now = excess(picture, reference);
    if (has_last_ && moves_)
      if (const auto value = flicker_between(contender.last_excess, now, motion_, steadiness_.pixels()))
        add_sample(contender.figures, "flicker", *value);
    contender.last_excess = std::move(now);
    return flip;
  }

  const Measurement& m_;
  Measured& into_;
  std::vector<Contender> contenders_; // the modes, then the steps of supersampling
  std::map<uint32_t, SupersampledFrame> references_;
  Steadiness steadiness_;
  FloatImage motion_;
  bool has_last_ = false, moves_ = true; // what rests cannot flicker: it may shimmer
  FrameKeeper keeper_;
};

} // namespace

std::vector<uint32_t> reference_frames(const Protocol& protocol) {
  const uint32_t pairs = std::max(1u, protocol.references / 2);
  uint32_t apart = protocol.measured / pairs;
  while (apart > 2 && std::gcd(apart, jitter_points) != 1)
    --apart; // or all would be of one phase of the jitter
  std::vector<uint32_t> frames;
  for (uint32_t pair = 0; pair < pairs; ++pair) {
    const uint32_t second = last_frame(protocol) - pair * apart;
    frames.insert(frames.end(), {second, second - 1});
  }
  std::ranges::reverse(frames);
  return frames;
}

void measure_error(const Measurement& m, Measured& into) {
  std::vector<ModeRun> runs = m.modes;
  runs.push_back({.name = "surfaces", .taa = {}}); // without jitter: what was visible where
  Errors errors(m, into);
  errors.draw_references();
  for (uint32_t frame = 0; frame <= last_frame(m.protocol); ++frame) {
    FrameInput input = m.film.at(frame);
    input.modes = runs;
    if (errors.wanted(frame)) {
      if (asks(m, Aspect::flicker)) input.wanted = surfaces_wanted(m.modes.size());
      for (size_t mode = 0; mode < m.modes.size(); ++mode) input.wanted.push_back({Output::display, mode});
    }
    FrameResult result = m.film.draw(input);
    if (errors.wanted(frame)) errors.take(frame, input.wanted, result);
  }
  errors.finish();
  into.error_frames = reference_frames(m.protocol), into.samples = m.protocol.samples;
}

} // namespace unghost
