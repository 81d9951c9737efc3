#include <map>
#include <set>

#include <gtest/gtest.h>

#include "renderer/geometry_sharing.h"
#include "renderer/settings.h"
#include "renderer/view.h"

namespace unghost {
namespace {

size_t period_of(Jitter sequence) {
  size_t period = 1;
  while (period < 64) {
    bool repeats = true;
    for (uint64_t i = 0; i < 64; ++i)
      repeats = repeats && jitter_offset(sequence, i) == jitter_offset(sequence, i + period);
    if (repeats) return period;
    ++period;
  }
  return 0;
}

TEST(Jitters, StayInTheirPixelAboutItsMiddleAndRepeat) {
  const std::map<Jitter, size_t> periods = {
      {Jitter::none, 1},   {Jitter::halton_8, 8},    {Jitter::halton_16, 16},  {Jitter::blue_noise_16, 16},
      {Jitter::r2_10, 10}, {Jitter::two_samples, 2}, {Jitter::rotated_grid, 4}};
  for (const Answer& answer : answers<Jitter>()) {
    const Jitter sequence = Jitter(answer.value);
    const size_t period = period_of(sequence);
    EXPECT_EQ(period, periods.at(sequence)) << answer.name;
    glm::dvec2 mean(0);
    std::set<std::pair<double, double>> places;
    for (size_t i = 0; i < period; ++i) {
      const glm::dvec2 at = jitter_offset(sequence, i);
      EXPECT_TRUE(at.x >= -0.5 && at.x < 0.5 && at.y >= -0.5 && at.y < 0.5) << answer.name << " " << i;
      mean += at / double(period);
      places.insert({at.x, at.y});
    }
    EXPECT_EQ(places.size(), period) << answer.name;
    // Halton's few points are as published
    EXPECT_LT(glm::length(mean), sequence == Jitter::r2_10 ? 1e-9 : 0.12) << answer.name;
  }
}

TEST(Jitters, FillLessWhileTheCameraMoves) {
  ModeRun less{"less", settings_for_mode("rgb").taa}, all = less;
  less.taa.jitter_scale = 0.8f, less.taa.jitter_moving = 0.5f;
  all.taa.jitter_scale = 0.8f;
  FrameInput input;
  input.index = 3, input.modes = {less, all};
  EXPECT_EQ(jitter_of(less.taa, input), jitter_of(all.taa, input));
  EXPECT_EQ(share_geometries(input).settings.size(), 1u);
  input.now.eye.x += 1e-9;
  EXPECT_EQ(jitter_of(less.taa, input), 0.5 * jitter_of(all.taa, input));
  EXPECT_NE(jitter_of(less.taa, input), glm::dvec2(0));
  EXPECT_EQ(share_geometries(input).settings.size(), 2u);
  input.jitter_px = glm::dvec2(0.25, 0);
  EXPECT_EQ(jitter_of(less.taa, input), glm::dvec2(0.25, 0));
  EXPECT_EQ(share_geometries(input).settings.size(), 1u);
}

} // namespace
} // namespace unghost
