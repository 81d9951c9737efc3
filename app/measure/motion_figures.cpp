// Ghosting and trail: frames in motion without jitter, so that all modes share the aliased frame's geometry.
#include <algorithm>

#include "app/measure/kept_frames.h"
#include "app/measure/measure_parts.h"
#include "app/measure/trail.h"

namespace unghost {
namespace {

// Aliased and accumulated first, then the modes.
constexpr size_t aliased = 0, accumulated = 1, first_mode = 2;

std::vector<ModeRun> runs_of(const Measurement& m) {
  std::vector<ModeRun> runs(first_mode);
  runs[aliased].name = "aliased", runs[accumulated].name = "accumulated";
  runs[accumulated].taa.policy = {
      .history = HistoryFilter::catmull_rom, .reject = Reject::off_screen, .blend = Blend::constant};
  for (const ModeRun& mode : m.modes) {
    runs.push_back(mode);
    runs.back().taa.policy.jitter = Jitter::none;
  }
  return runs;
}

class Motion {
public:
  Motion(const Measurement& m, Measured& into)
      : m_(m), into_(into), meter_(m.modes.size(), m.film.at(0).settings.light.exposure_ev),
        keeper_(m, "ghosting") {}

  std::vector<Wanted> wants(uint32_t frame) const {
    std::vector<Wanted> wanted;
    const bool counts = frame >= m_.protocol.fill;
    if (asks(m_, Aspect::trail)) wanted = surfaces_wanted();
    for (size_t run = 0; run < first_mode + m_.modes.size() && counts; ++run) {
      if (asks(m_, Aspect::trail)) wanted.push_back({Output::resolved, run});
      if (asks(m_, Aspect::ghosting) && run != accumulated) wanted.push_back({Output::display, run});
    }
    return wanted;
  }

  void take(uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result) {
    if (asks(m_, Aspect::trail)) take_trail(frame, wanted, result);
    if (asks(m_, Aspect::ghosting) && frame >= m_.protocol.fill) take_ghosting(frame, wanted, result);
  }

  void finish() {
    for (size_t mode = 0; mode < m_.modes.size() && asks(m_, Aspect::trail); ++mode)
      set_trail(into_.rows[mode], meter_.trail_of(mode), meter_.frames_of(mode));
    keeper_.finish(into_);
  }

private:
  void take_trail(uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result) {
    steadiness_.advance(surfaces_of(wanted, result));
    if (frame < m_.protocol.fill) return;
    const auto resolved = [&](size_t run) -> const FloatImage& {
      return delivered(wanted, result, Output::resolved, run).image;
    };
    TrailImages images{.aliased = resolved(aliased), .accumulated = resolved(accumulated), .resolved = {}};
    for (size_t mode = 0; mode < m_.modes.size(); ++mode)
      images.resolved.push_back(&resolved(first_mode + mode));
    meter_.add(steadiness_.pixels(), images);
  }

  void take_ghosting(uint32_t frame, const std::vector<Wanted>& wanted, FrameResult& result) {
    const Image& reference = delivered(wanted, result, Output::display, aliased).picture;
    const SeenPicture seen_reference = seen(reference);
    for (size_t mode = 0; mode < m_.modes.size(); ++mode) {
      const TaaSettings& taa = m_.modes[mode].taa;
      const bool same = !taa.policy.needs_history() && taa.sharpen == 0;
      const Image& picture = delivered(wanted, result, Output::display, first_mode + mode).picture;
      const double flip = same ? 0 : mean_flip(seen_reference, seen(picture));
      add_sample(into_.rows[mode], "ghosting", flip);
      keeper_.offer({.mode = mode, .frame = frame, .flip = flip, .picture = picture, .reference = reference});
    }
  }

  static void set_trail(MeasuredMode& row, const Trail& trail, const std::vector<TrailMeter::Sums>& frames) {
    const auto set = [&](const char* name, const std::optional<double>& value) {
      if (value) row.figures[name] = *value;
    };
    set("trail", trail.whole), set("trail_surface", trail.surface), set("trail_shadow", trail.shadow);
    for (const TrailMeter::Sums& sums : frames) {
      row.samples["trail_remaining"].push_back(rounded(sums.remaining));
      row.samples["trail_all"].push_back(rounded(sums.all));
    }
  }

  const Measurement& m_;
  Measured& into_;
  TrailMeter meter_;
  Steadiness steadiness_;
  FrameKeeper keeper_;
};

} // namespace

void measure_motion(const Measurement& m, Measured& into) {
  const std::vector<ModeRun> runs = runs_of(m);
  Motion motion(m, into);
  for (uint32_t frame = 0; frame <= last_frame(m.protocol); ++frame) {
    FrameInput input = m.film.at(frame);
    input.modes = runs;
    input.wanted = motion.wants(frame);
    FrameResult result = m.film.draw(input);
    motion.take(frame, input.wanted, result);
  }
  motion.finish();
  if (asks(m, Aspect::ghosting)) set_means(into, "ghosting");
}

} // namespace unghost
