// The fast resolve against the naive one, which is its definition.
#include <cmath>
#include <random>

#include <glm/gtc/packing.hpp>

#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

class Resolvers : public StudioTest {};

/// Units in the last place of a half float between two that are not negative.
int half_ulps(float a, float b) { return std::abs(int(glm::packHalf1x16(a)) - int(glm::packHalf1x16(b))); }

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
      for (size_t i = 0; i < a.size(); ++i) most = std::max(most, half_ulps(a[i], b[i]));
      EXPECT_LE(most, 2) << modes[mode].name << " frame " << index;
    }
  }
}

TEST_F(Resolvers, AgreeOnEveryRow) {
  std::vector<ModeRun> modes;
  for (const TaaMode& mode : taa_modes()) modes.push_back(run_of(mode.name));
  expect_agreement(*studio, modes, 8);
}

// Answers that no row has. Where samples lie is nothing to a resolve.
TEST_F(Resolvers, AgreeOnEveryAnswer) {
  std::vector<ModeRun> modes;
  for (const Setting& row : settings_table()) {
    if (!row.per_mode || row.kind == SettingKind::number || row.name.ends_with("jitter")) continue;
    for (const Answer& answer : row.answers) {
      Settings settings = settings_for_mode(row.name == "axes" ? "dop32" : "ycocg-var");
      row.write(settings, answer.value);
      if (refusal(settings) || !settings.taa.policy.needs_history()) continue;
      modes.push_back({std::string(row.name) + "=" + answer.name, settings.taa});
    }
  }
  expect_agreement(*studio, modes, 2);
}

/// Numbers that a frame may hold, the extreme ones among them.
float any_number(std::mt19937& random, bool extreme) {
  static constexpr float limit = 65504, infinite = std::numeric_limits<float>::infinity();
  static constexpr float odd[] = {0, 1e-7f, 6e-5f, 1, limit, infinite, -infinite, -1, NAN};
  if (extreme && random() % 8 == 0) return odd[random() % std::size(odd)];
  return std::exp2(float(random() % 2000) / 200 - 7);
}

Inputs random_inputs(std::mt19937& random) {
  Inputs inputs(13, 9);
  const bool extreme = random() % 2 == 0;
  for (size_t i = 0; i < inputs.colours.size(); ++i) {
    for (int c = 0; c < 3; ++c) inputs.colours[i][c] = any_number(random, extreme);
    const float reach = std::exp2(float(random() % 12) - 6);
    inputs.motion[i] = glm::vec2(int(random() % 2001) - 1000, int(random() % 2001) - 1000) * (reach / 1000);
    if (extreme && random() % 16 == 0) inputs.motion[i].x = any_number(random, true) * 1e6f;
    inputs.depth[i] = float(random() % 1000) / 10000;
    inputs.expected_depth[i] = 0.1f / std::max(inputs.depth[i], 1e-6f);
    inputs.objects[i] = random() % 3, inputs.tags[i] = uint8_t(random() % 2);
  }
  return inputs;
}

class HandMade : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : bench.messages()) ADD_FAILURE() << message;
  }
  ResolveBench bench;
};

TEST_F(HandMade, ResolversAgreeOnWhateverComesInAndStayFinite) {
  for (uint32_t seed = 0; seed < 6; ++seed) {
    std::mt19937 random(seed);
    std::vector<ModeRun> runs;
    for (const TaaMode& mode : taa_modes())
      for (const Resolver resolver : {Resolver::fast, Resolver::naive}) {
        if (!mode.settings.policy.needs_history()) continue;
        runs.push_back(run_of(mode.name));
        runs.back().taa.resolver = resolver;
      }
    for (int frame = 0; frame < 3; ++frame) {
      const auto results = bench.resolve(random_inputs(random), runs, frame == 0);
      for (size_t run = 0; run < runs.size(); run += 2)
        for (size_t i = 0; i < results[run].size(); ++i)
          for (int c = 0; c < 3; ++c) {
            const float fast = results[run][i][c], naive = results[run + 1][i][c];
            ASSERT_TRUE(std::isfinite(fast) && fast >= 0) << runs[run].name << " " << seed << " " << i;
            ASSERT_LE(half_ulps(fast, naive), 2)
                << runs[run].name << " " << seed << " " << i << ": " << fast << " " << naive;
          }
    }
  }
}

/// With a weight of 0 and no motion the result is the rectified history.
std::vector<glm::vec3> rectified(ResolveBench& bench, const char* mode, const Inputs& history,
                                 const Inputs& now) {
  ModeRun run = run_of(mode);
  run.taa.alpha = 0;
  run.taa.policy.history = HistoryFilter::nearest;
  run.taa.policy.dilation = Dilation::centre;
  bench.resolve(history, {run}, true);
  return bench.resolve(now, {run}, false)[0];
}

glm::dvec3 half(glm::vec3 c) {
  return glm::dvec3(glm::vec3(glm::unpackHalf4x16(glm::packHalf4x16(glm::vec4(c, 1)))));
}

// Plain double precision: in the box, on the segment, and what is inside as it was.
TEST_F(HandMade, AClipLiesOnItsSegmentAndInItsVolume) {
  std::mt19937 random(7);
  Inputs history(24, 24), now(24, 24);
  for (Inputs* inputs : {&history, &now})
    for (glm::vec3& colour : inputs->colours)
      colour = half({any_number(random, false), any_number(random, false), any_number(random, false)});
  for (const std::string mode : {"gdk-clip", "rgb", "dop32", "dop16-opt"}) {
    const std::vector<glm::vec3> results = rectified(bench, mode.c_str(), history, now);
    size_t unchanged = 0, moved = 0;
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const size_t i = size_t(24 * y + x);
        const glm::dvec3 h(history.colours[i]), c(now.colours[i]), r(results[i]);
        glm::dvec3 low(1e30), high(-1e30);
        for (int k = 0; k < 9; ++k) {
          const int u = std::clamp(x + k % 3 - 1, 0, 23), v = std::clamp(y + k / 3 - 1, 0, 23);
          low = glm::min(low, glm::dvec3(now.colours[size_t(24 * v + u)]));
          high = glm::max(high, glm::dvec3(now.colours[size_t(24 * v + u)]));
        }
        const double error = 2e-3 * glm::length(glm::max(h, c)); // what two half floats are apart
        const double along = glm::dot(r - c, h - c) / std::max(glm::dot(h - c, h - c), 1e-30);
        EXPECT_LT(glm::distance(r, c + std::clamp(along, 0.0, 1.0) * (h - c)), error) << mode << i;
        const bool in_box = glm::all(glm::greaterThanEqual(h, low)) && glm::all(glm::lessThanEqual(h, high));
        const bool stays =
            glm::all(glm::greaterThanEqual(r, low - error)) && glm::all(glm::lessThanEqual(r, high + error));
        EXPECT_TRUE(stays || mode == "dop16-opt") << mode << i; // whose axes are not the box's
        if (in_box && !mode.starts_with("dop")) {
          EXPECT_EQ(r, h) << mode << i;
        }
        (r == h ? unchanged : moved) += 1;
      }
    EXPECT_GT(unchanged, 10) << mode;
    EXPECT_GT(moved, 10) << mode;
  }
}

// The hull lies in the polytope, the polytope in the box: a history that the smaller one leaves, the larger
// leaves, too.
TEST_F(HandMade, VolumesNest) {
  std::mt19937 random(8);
  Inputs history(24, 24), now(24, 24);
  for (Inputs* inputs : {&history, &now})
    for (glm::vec3& colour : inputs->colours)
      colour = half({any_number(random, false), any_number(random, false), any_number(random, false)});
  for (size_t i = 0; i < now.colours.size(); i += 2) { // a mean of neighbours lies in their hull
    const size_t left = i % 24 > 0 ? i - 1 : i, right = i % 24 < 23 ? i + 1 : i;
    history.colours[i] = half((now.colours[left] + now.colours[right]) / 2.0f);
  }
  const auto box = rectified(bench, "rgb", history, now), dop = rectified(bench, "dop32", history, now);
  size_t kept_by_dop = 0, kept_by_box = 0;
  for (size_t i = 0; i < box.size(); ++i) {
    if (i % 2 == 0) {
      EXPECT_LT(glm::distance(dop[i], history.colours[i]), 2e-3f * glm::length(history.colours[i]) + 1e-4f)
          << i;
    }
    const bool in_dop = dop[i] == history.colours[i], in_box = box[i] == history.colours[i];
    EXPECT_TRUE(!in_dop || in_box) << i;
    kept_by_dop += in_dop, kept_by_box += in_box;
  }
  EXPECT_LT(kept_by_dop, kept_by_box) << "and the polytope is tighter";
}

// A polytope of three axes is the box.
TEST_F(HandMade, ThreeAxesAreTheBox) {
  std::mt19937 random(9);
  Inputs history(24, 24), now(24, 24);
  for (Inputs* inputs : {&history, &now})
    for (glm::vec3& colour : inputs->colours)
      colour = {any_number(random, false), any_number(random, false), any_number(random, false)};
  ModeRun box = run_of("rgb"), axes = run_of("dop32");
  axes.taa.policy.axes = Axes::xyz;
  bench.resolve(history, {box, axes}, true);
  const auto results = bench.resolve(now, {box, axes}, false);
  EXPECT_EQ(results[0], results[1]);
}

// What the articles do where tags differ: the picture, blurred, and nothing of the history.
TEST_F(HandMade, WhereTagsDifferTheHistoryIsGone) {
  Inputs before(16, 16), now(16, 16);
  std::mt19937 random(10);
  for (glm::vec3& colour : before.colours) colour = glm::vec3(9, 0, 9);
  for (glm::vec3& colour : now.colours) colour = half(glm::vec3(any_number(random, false)));
  now.tags[16 * 8 + 8] = 1;
  ModeRun run = run_of("uncharted");
  run.taa.policy.dilation = Dilation::centre;
  run.taa.policy.rectify = Rectify::none;
  bench.resolve(before, {run}, true);
  const auto result = bench.resolve(now, {run}, false)[0];
  double blurred = 0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      blurred += now.colours[size_t(16 * (8 + y) + 8 + x)].x * (2 - std::abs(x)) * (2 - std::abs(y)) / 16.0;
  EXPECT_NEAR(result[16 * 8 + 8].x, blurred, 1e-3 * blurred);
  EXPECT_NEAR(result[16 * 8 + 8].y, blurred, 1e-3 * blurred);
  EXPECT_NEAR(result[16 * 4 + 4].x, 0.9 * 9 + 0.1 * now.colours[16 * 4 + 4].x, 0.02);
}

} // namespace
} // namespace unghost
