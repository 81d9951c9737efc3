#include "app/progress.h"

#include <algorithm>
#include <cmath>

namespace unghost {

Progress::Progress(const Console& console, double work) : console_(console), work_(work) {}

Progress::~Progress() {
  if (console_.terminal && !console_.quiet && done_ > 0) console_.err << "\r\033[K" << std::flush;
}

void Progress::step(double work) {
  done_ += work;
  const Clock::time_point now = Clock::now();
  if (!console_.terminal || console_.quiet || now - shown_ < std::chrono::milliseconds(200)) return;
  shown_ = now;
  show();
}

void Progress::show() {
  const double all = std::max(work_ - left_out_, done_), share = all > 0 ? done_ / all : 1;
  const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
  console_.err << "\r\033[K" << what_ << (what_.empty() ? "" : ": ") << int(100 * share) << "%";
  if (seconds > 3) console_.err << ", about " << duration_text(seconds * (1 - share) / share) << " left";
  console_.err << std::flush;
}

std::string duration_text(double seconds) {
  const auto whole = int64_t(std::ceil(seconds));
  const auto two = [](int64_t large, const char* unit, int64_t small, const char* small_unit) {
    return std::to_string(large) + unit + (small > 0 ? " " + std::to_string(small) + small_unit : "");
  };
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return two(whole / 60, " min", whole % 60, " s");
  return two(whole / 3600, " h", whole % 3600 / 60, " min");
}

} // namespace unghost
