// Histories hold light in a unit that steps with the exposure: within a step they go on, beyond it they begin
// anew.
#include <cmath>

#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class ExposureSteps : public StudioTest {
protected:
  /// How much of the frame is in each mode's picture, of 255, in the mean.
  std::vector<double> weights(float exposure_ev) {
    const std::vector<ModeRun> modes{run_of("unghost"), run_of("unghost-safe"), run_of("blend")};
    FrameInput input = studio->frame("still", index++, modes,
                                     {{Output::display, 0}, {Output::display, 1}, {Output::display, 2}});
    input.width = 96, input.height = 54;
    input.settings.view = View::weight;
    input.settings.light.exposure_ev = exposure_ev;
    std::vector<double> means;
    for (const Delivered& of : studio->renderer.render(input).delivered) {
      double sum = 0;
      for (size_t i = 0; i < of.picture.rgba.size(); i += 4) sum += of.picture.rgba[i];
      means.push_back(4 * sum / double(of.picture.rgba.size()));
    }
    return means;
  }
  int index = 0;
};

TEST_F(ExposureSteps, BeginHistoriesOfLightAnewAndOnlyThose) {
  constexpr double all = 255, some = 90;
  float before = 0;
  for (int frame = 0; frame < 20; ++frame) weights(before);
  for (const float ev : {0.3f, -0.4f, 0.4f, 0.6f, 1.4f, 0.4f, -0.6f}) {
    const std::vector<double> taken = weights(ev);
    const bool stays = std::round(ev) == std::round(before);
    for (const size_t keyed : {0, 1}) {
      const double least = stays ? 0 : all, most = stays ? some : all;
      EXPECT_TRUE(least <= taken[keyed] && taken[keyed] <= most)
          << taken[keyed] << " from " << before << " to " << ev;
    }
    EXPECT_LT(taken[2], some) << before << " to " << ev;
    for (int frame = 0; frame < 20; ++frame) weights(ev);
    before = ev;
  }
}

} // namespace
} // namespace unghost
