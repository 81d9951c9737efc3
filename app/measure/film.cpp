#include "app/measure/film.h"

#include <algorithm>

namespace unghost {

double work_of(const FrameInput& input) {
  // in times of geometry and light at 640x360 on two cores of lavapipe
  constexpr double resolve = 0.15, naive_resolve = 0.5, judged = 0.3;
  double work = 1;
  for (const ModeRun& mode : input.modes)
    if (mode.taa.policy.needs_history())
      work += mode.taa.resolver == Resolver::fast ? resolve : naive_resolve;
  const auto pictures = std::ranges::count(input.wanted, Output::display, &Wanted::what);
  return work + judged * double(pictures);
}

Delivered& delivered(const std::vector<Wanted>& wanted, FrameResult& result, Output what, size_t mode) {
  const auto found = std::ranges::find_if(
      wanted, [&](const Wanted& each) { return each.what == what && each.mode == mode; });
  return result.delivered.at(size_t(found - wanted.begin()));
}

bool same_moment(const Film& film, uint32_t a, uint32_t b) {
  Instant first = film.at(a).now, second = film.at(b).now;
  if (!film.animated) first.animation_s = second.animation_s = 0; // a clock that nobody reads
  return first == second;
}

FrameInput at_rest(const Film& film, uint32_t frame) {
  FrameInput input = film.at(frame);
  input.before = input.now;
  input.cut = true;
  return input;
}

} // namespace unghost
