// The scale that holds a frame time.
#include "app/demo/render_scale.h"

#include <cmath>

#include <gtest/gtest.h>

namespace unghost {
namespace {

TEST(DemoScale, HoldsATimeThatPixelsAndGeometryShare) {
  for (const double fixed_ms : {0.0, 4.0, 12.0})
    for (const double pixels_ms : {5.0, 20.0, 60.0}) {
      const auto ms = [&](double scale) { return fixed_ms + pixels_ms * scale * scale; };
      constexpr double wanted = 25;
      double scale = 1;
      for (int look = 0; look < 20; ++look) scale = next_scale(scale, ms(scale), wanted);
      const bool at_an_end = scale == 1 || scale == least_scale;
      EXPECT_TRUE(ms(scale) <= wanted * 1.1 || scale == least_scale) << fixed_ms << " " << pixels_ms;
      EXPECT_TRUE(at_an_end || ms(scale + 2 * scale_step) > wanted) << "smaller than it has to be";
      EXPECT_EQ(next_scale(scale, ms(scale), wanted), scale) << "it comes to rest";
    }
}

TEST(DemoScale, StaysInItsRangeWhateverIsMeasured) {
  for (const double ms : {0.0, -1.0, 1e-9, 1e9, double(NAN), double(INFINITY)}) {
    const double scale = next_scale(0.7, ms, 16);
    EXPECT_TRUE(scale >= least_scale && scale <= 1) << ms;
  }
}

} // namespace
} // namespace unghost
