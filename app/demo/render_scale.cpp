#include "app/demo/render_scale.h"

#include <algorithm>
#include <cmath>

namespace unghost {

double next_scale(double scale, double measured_ms, double wanted_ms) {
  if (!(measured_ms > 0) || std::abs(measured_ms / wanted_ms - 1) < 0.1) return scale;
  // times follow the pixels, but for what geometry takes at any size: the next look corrects that
  const double wanted =
      std::floor(scale * std::sqrt(wanted_ms / measured_ms) / scale_step + 1e-6) * scale_step;
  return std::clamp(wanted, least_scale, 1.0);
}

} // namespace unghost
