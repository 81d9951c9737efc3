// What every resolve is for: a still picture comes closer to the supersampled one.
#include <cmath>

#include "shaders/shared/tonemap.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Convergence : public StudioTest {};

/// Mean of `samples` frames at a frozen clock in linear light (R2 sequence, Roberts 2018), then as displayed.
std::vector<float> supersampled(Studio& studio, const FrameInput& still, int samples) {
  std::vector<double> sum;
  for (int n = 0; n < samples; ++n) {
    FrameInput input = still;
    input.modes = {run_of("off")};
    input.wanted = {{Output::resolved}};
    const double p = 1.32471795724475;
    input.jitter_px = {std::fmod(0.5 + n / p, 1.0) - 0.5, std::fmod(0.5 + n / (p * p), 1.0) - 0.5};
    const std::vector<float> values = studio.renderer.render(input).delivered[0].image.values;
    sum.resize(values.size());
    for (size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
  }
  std::vector<float> display(sum.size());
  for (size_t i = 0; i < sum.size(); i += 3) {
    const glm::vec3 shown = display_from_linear(glm::vec3(sum[i], sum[i + 1], sum[i + 2]) / float(samples));
    display[i] = shown.x, display[i + 1] = shown.y, display[i + 2] = shown.z;
  }
  return display;
}

double mean_difference(const Image& picture, const std::vector<float>& display) {
  double sum = 0;
  for (size_t pixel = 0; pixel < display.size() / 3; ++pixel)
    for (size_t channel = 0; channel < 3; ++channel)
      sum += std::abs(double(picture.rgba[4 * pixel + channel]) / 255 - display[3 * pixel + channel]);
  return sum / double(display.size());
}

/// A tighter volume than the box gives up more of what is right (Ikkala et al. 2024), and two frames are two
/// samples.
double share_left(const TaaPolicy& policy) {
  return policy.keeps == Keeps::input || policy.uses_variance() || policy.uses_dop() ? 0.6 : 0.5;
}

TEST_F(Convergence, EveryModeLowersTheErrorOfAStillPicture) {
  std::vector<ModeRun> modes;
  for (const TaaMode& mode : taa_modes()) modes.push_back(run_of(mode.name));
  FrameResult last;
  for (int frame = 0; frame < 64; ++frame) {
    FrameInput input = studio->frame("still", frame, modes, {});
    if (frame == 63)
      for (size_t i = 0; i < modes.size(); ++i) input.wanted.push_back({Output::display, i});
    last = studio->renderer.render(input);
  }
  const std::vector<float> reference = supersampled(*studio, studio->frame("still", 0, {}, {}), 64);
  const double off = mean_difference(last.delivered[0].picture, reference);
  ASSERT_EQ(modes[0].name, "off");
  EXPECT_GT(off, 0.005) << "there is something to smooth";
  for (size_t i = 1; i < modes.size(); ++i) {
    const double error = mean_difference(last.delivered[i].picture, reference);
    EXPECT_LT(error, share_left(modes[i].taa.policy) * off) << modes[i].name;
    RecordProperty(modes[i].name + "_over_off", std::to_string(error / off));
    std::printf("%-12s %.5f of off's %.5f: %.2f\n", modes[i].name.c_str(), error, off, error / off);
  }
}

} // namespace
} // namespace unghost
