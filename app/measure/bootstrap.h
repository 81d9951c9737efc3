// How far a figure has changed between two measurements, and how sure that is: intervals by resampling (Efron
// 1979). The same samples give the same interval on every run.
#pragma once

#include <vector>

namespace unghost {

/// A figure of frames, one entry a frame: the sum of the parts over the sum of the wholes. A mean has 1 as
/// the whole of every frame.
struct FrameShares {
  std::vector<double> parts, wholes;
};
/// 0 where the wholes have no sum.
double share_of(const FrameShares& frames);

/// Of what was before: 0.1 is a tenth more. `low` and `high` bound 95%.
struct RelativeChange {
  double change = 0, low = 0, high = 0;
};
/// (after - before) / before; over `least` where `before` is below that, so that nothing is divided by 0 and
/// what is too small to be read makes no change.
double relative_change(double before, double after, double least);

/// At least two frames of each. `paired`: both are of the same frames, which are then drawn together;
/// `successive`: neighbours are alike.
struct FramePairing {
  bool paired = true, successive = true;
};
RelativeChange change_of_frames(const FrameShares& before, const FrameShares& after, FramePairing pairing,
                                double least);
/// Of medians of rounds, each drawn apart; at least one of each.
RelativeChange change_of_medians(const std::vector<double>& before, const std::vector<double>& after,
                                 double least);

} // namespace unghost
