// The fast resolve against the naive one, which is its definition.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glm/gtc/packing.hpp>

#include "shaders/shared/taa_key.h"
#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Resolvers : public StudioTest {};

/// Units in the last place of a half float between two that are not negative.
int half_ulps(float a, float b) {
  return a == b ? 0 : std::abs(int(glm::packHalf1x16(a)) - int(glm::packHalf1x16(b)));
}

/// Each of `modes` by both resolvers, from the same frames: nowhere are they more than 2 half-float ulps
/// apart.
void expect_agreement(Studio& studio, const std::vector<ModeRun>& modes, int frames) {
  std::vector<ModeRun> runs;
  std::vector<Wanted> wanted;
  for (const ModeRun& mode : modes)
    for (const Resolver resolver : {Resolver::fast, Resolver::naive}) {
      wanted.push_back({Output::resolved, runs.size()});
      runs.push_back(mode);
      runs.back().taa.resolver = resolver;
    }
  for (int index = 0; index < frames; ++index) {
    FrameInput input = studio.frame("drive", index, runs, wanted);
    input.width = 161, input.height = 91; // nothing divides them
    const FrameResult result = studio.renderer.render(input);
    for (size_t mode = 0; mode < modes.size(); ++mode) {
      const std::vector<float>&a = result.delivered[2 * mode].image.values,
            &b = result.delivered[2 * mode + 1].image.values;
      int most = 0;
      for (size_t i = 0; i < a.size(); ++i) {
        ASSERT_TRUE(std::isfinite(a[i]) && std::isfinite(b[i])) << modes[mode].name << " frame " << index;
        most = std::max(most, half_ulps(a[i], b[i]));
      }
      EXPECT_LE(most, 2) << modes[mode].name << " frame " << index;
    }
  }
}

TEST_F(Resolvers, AgreeOnEveryRow) {
  std::vector<ModeRun> modes;
  for (const TaaMode& mode : taa_modes()) modes.push_back(run_of(mode.name));
  expect_agreement(*studio, modes, 8);
}

/// Answers that no row has, one in place of each of a small row's own. Where samples lie is nothing to a
/// resolve.
std::vector<ModeRun> answers_by_one() {
  Settings base = settings_for_mode("gdk-clamp"); // of each column but one it has the first answer
  base.taa.policy.dilation = Dilation::closest_depth;
  std::vector<ModeRun> modes = {{"base", base.taa}};
  for (const Setting& row : settings_table()) {
    if (!row.per_mode || row.kind == SettingKind::number || row.name.ends_with("jitter")) continue;
    for (const Answer& answer : row.answers) {
      Settings settings = base;
      if (row.name == "axes") settings.taa.policy.rectify = Rectify::dop_clip;
      if (row.name == "ringing") settings.taa.policy.history = HistoryFilter::catmull_rom;
      row.write(settings, answer.value);
      const bool known =
          std::ranges::any_of(modes, [&](const ModeRun& run) { return run.taa == settings.taa; });
      if (known || refusal(settings) || !settings.taa.policy.needs_history()) continue;
      modes.push_back({std::string(row.name) + "=" + answer.name, settings.taa});
    }
  }
  base.taa.policy.reject = Reject::velocity, base.taa.policy.fill = Fill::plain;
  modes.push_back({"velocity, plain", base.taa});
  return modes;
}

TEST_F(Resolvers, AgreeOnEveryAnswer) { expect_agreement(*studio, answers_by_one(), 2); }

Inputs random_inputs(std::mt19937& random) {
  Inputs inputs(13, 9);
  const bool extreme = random() % 2 == 0;
  inputs.moved_ids = uint32_t(random() & random());
  inputs.jitter_px = glm::vec2(int(random() % 1001) - 500, int(random() % 1001) - 500) / 1000.0f;
  for (size_t i = 0; i < inputs.colours.size(); ++i) {
    for (int c = 0; c < 3; ++c) inputs.colours[i][c] = any_number(random, extreme);
    const float reach = std::exp2(float(random() % 12) - 6);
    inputs.motion[i] = glm::vec2(int(random() % 2001) - 1000, int(random() % 2001) - 1000) * (reach / 1000);
    if (extreme && random() % 16 == 0) inputs.motion[i].x = any_number(random, true) * 1e6f;
    inputs.depth[i] = float(random() % 1000) / 10000;
    inputs.expected_depth[i] = 0.1f / std::max(inputs.depth[i], 1e-6f);
    const uint32_t id = random() % 4 == 0 ? uint32_t(random() % (OBJECT_IDS + 1)) : 20;
    inputs.objects[i] =
        uint32_t(random() % 3) | id << OBJECT_ID_SHIFT | (random() % 8 == 0 ? OBJECT_GLOSSY : 0);
    inputs.light[i] = random() % 2 == 0 ? 1 : float(random() % 3000) / 1000;
    inputs.tags[i] = uint8_t(random() % 2);
  }
  return inputs;
}

using HandMade = ResolveBenchTest;

/// `pictures` random ones, four frames of each sequence: nowhere more than 2 half-float ulps apart, and
/// finite.
void expect_agreement_by_chance(ResolveBench& bench, const std::vector<ModeRun>& modes, uint32_t pictures) {
  std::vector<ModeRun> runs;
  for (const ModeRun& mode : modes)
    for (const Resolver resolver : {Resolver::fast, Resolver::naive})
      runs.emplace_back(mode).taa.resolver = resolver;
  std::mt19937 random(1);
  for (uint32_t picture = 0; picture < pictures; ++picture) {
    const auto results = bench.resolve(random_inputs(random), runs, picture % 4 == 0);
    for (size_t run = 0; run < runs.size(); run += 2)
      for (size_t i = 0; i < results[run].size(); ++i)
        for (int c = 0; c < 3; ++c) {
          const float fast = results[run][i][c], naive = results[run + 1][i][c];
          ASSERT_TRUE(std::isfinite(fast) && fast >= 0) << runs[run].name << " " << picture << " " << i;
          ASSERT_LE(half_ulps(fast, naive), 2)
              << runs[run].name << " " << picture << " " << i << ": " << fast << " " << naive;
        }
  }
}

TEST_F(HandMade, ResolversAgreeOnWhateverComesInAndStayFinite) {
  std::vector<ModeRun> modes;
  for (const TaaMode& mode : taa_modes())
    if (mode.settings.policy.needs_history()) modes.push_back(run_of(mode.name));
  expect_agreement_by_chance(bench, modes, 200);
}

TEST_F(HandMade, ResolversAgreeOnWhateverComesInByEveryAnswer) {
  expect_agreement_by_chance(bench, answers_by_one(), 100);
}

} // namespace
} // namespace unghost
