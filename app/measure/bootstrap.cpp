#include "app/measure/bootstrap.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "app/measure/quantile.h"

namespace unghost {
namespace {

constexpr size_t resamples = 2000;

/// splitmix64 (Steele, Lea and Flood 2014). The standard's distributions differ between libraries.
class Draws {
public:
  /// 0 to count - 1; count is far below 2^32.
  size_t below(size_t count) {
    uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return size_t(((z ^ (z >> 31)) >> 32) * count >> 32);
  }

private:
  uint64_t state_ = 1;
};

/// What neighbours share would be counted as if it were seen anew in each of them, and the interval come out
/// too narrow: so frames are drawn four at a time (Künsch 1989). A few frames are drawn in shorter blocks, so
/// that there are four to draw from. Of noise whose neighbours correlate by .5, a tenth is still called a
/// change, and a quarter by .8: frames that drift for long say little, however many there are.
size_t block_of(size_t frames, bool successive) {
  return successive ? std::clamp<size_t>(frames / 4, 1, 4) : 1;
}

/// As many frames as there are, in blocks that begin anywhere and go round the end (Politis and Romano 1992),
/// so that each frame is drawn equally often.
void draw_frames(Draws& draws, size_t frames, size_t block, std::vector<size_t>& drawn) {
  drawn.clear();
  while (drawn.size() < frames) {
    const size_t first = draws.below(frames);
    for (size_t i = 0; i < block && drawn.size() < frames; ++i) drawn.push_back((first + i) % frames);
  }
}

double share_of(const FrameShares& frames, const std::vector<size_t>& drawn) {
  double part = 0, whole = 0;
  for (const size_t frame : drawn) part += frames.parts[frame], whole += frames.wholes[frame];
  return whole > 0 ? part / whole : 0;
}

/// By how much the percentiles of few blocks are too near to one another: they know the spread only of what
/// they have (the factor of Student's t over the normal distribution), and that with the bias of a variance
/// over n in place of n - 1. After Hesterberg 2015, "What Teachers Should Know about the Bootstrap", 4.1.
double widening(size_t blocks) {
  static constexpr double t_975[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  const double freedom = double(blocks - 1), normal = 1.960;
  const double t = blocks - 1 <= std::size(t_975)
                       ? t_975[blocks - 2]
                       : normal + 2.372 / freedom + 2.822 / (freedom * freedom); // Fisher's expansion
  return t / normal * std::sqrt(double(blocks) / freedom);
}

/// The percentiles of what was drawn, that much further from the change.
RelativeChange between_percentiles(double change, const std::vector<double>& drawn, double wider) {
  return {.change = change,
          .low = change - wider * (change - quantile(drawn, 0.025)),
          .high = change + wider * (quantile(drawn, 0.975) - change)};
}

/// The median of as many rounds as there are, drawn from `sorted`; the rank is quantile's.
double drawn_median(Draws& draws, const std::vector<double>& sorted, std::vector<uint32_t>& times_drawn) {
  times_drawn.assign(sorted.size(), 0);
  for (size_t i = 0; i < sorted.size(); ++i) ++times_drawn[draws.below(sorted.size())];
  size_t at = 0;
  for (size_t below = times_drawn[0]; below <= sorted.size() / 2; below += times_drawn[at]) ++at;
  return sorted[at];
}

} // namespace

double share_of(const FrameShares& frames) {
  std::vector<size_t> all(frames.parts.size());
  std::iota(all.begin(), all.end(), size_t{0});
  return share_of(frames, all);
}

double relative_change(double before, double after, double least) {
  return (after - before) / std::max(before, least);
}

RelativeChange change_of_frames(const FrameShares& before, const FrameShares& after, FramePairing pairing,
                                double least) {
  assert(before.parts.size() >= 2 && after.parts.size() >= 2);
  assert(!pairing.paired || before.parts.size() == after.parts.size());
  Draws draws;
  const size_t block_before = block_of(before.parts.size(), pairing.successive),
               block_after = block_of(after.parts.size(), pairing.successive);
  std::vector<size_t> frames_before, frames_after;
  std::vector<double> drawn;
  for (size_t i = 0; i < resamples; ++i) {
    draw_frames(draws, before.parts.size(), block_before, frames_before);
    if (!pairing.paired) draw_frames(draws, after.parts.size(), block_after, frames_after);
    drawn.push_back(relative_change(share_of(before, frames_before),
                                    share_of(after, pairing.paired ? frames_before : frames_after), least));
  }
  const size_t blocks = std::min(before.parts.size() / block_before, after.parts.size() / block_after);
  return between_percentiles(relative_change(share_of(before), share_of(after), least), drawn,
                             widening(blocks));
}

RelativeChange change_of_medians(const std::vector<double>& before, const std::vector<double>& after,
                                 double least) {
  assert(!before.empty() && !after.empty());
  std::vector<double> sorted_before = before, sorted_after = after;
  std::ranges::sort(sorted_before), std::ranges::sort(sorted_after);
  Draws draws;
  std::vector<uint32_t> times_drawn;
  std::vector<double> drawn;
  for (size_t i = 0; i < resamples; ++i) {
    const double median = drawn_median(draws, sorted_before, times_drawn);
    drawn.push_back(relative_change(median, drawn_median(draws, sorted_after, times_drawn), least));
  }
  return between_percentiles(relative_change(quantile(before, 0.5), quantile(after, 0.5), least), drawn, 1);
}

} // namespace unghost
