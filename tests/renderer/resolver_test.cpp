// The fast resolve against the naive one, which is its definition.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glm/gtc/packing.hpp>

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
  Settings base =
      settings_for_mode("gdk-clamp"); // the smallest: of each column but one it has the first answer
  base.taa.policy.dilation = Dilation::closest_depth;
  std::vector<ModeRun> modes = {{"base", base.taa}};
  for (const Setting& row : settings_table()) {
    if (!row.per_mode || row.kind == SettingKind::number || row.name.ends_with("jitter")) continue;
    for (const Answer& answer : row.answers) {
      Settings settings = base;
      if (row.name == "axes") settings.taa.policy.rectify = Rectify::dop_clip;
      if (row.name == "ringing") settings.taa.policy.history = HistoryFilter::catmull_rom;
      row.write(settings, answer.value);
      const bool known = std::ranges::count(modes, settings.taa, &ModeRun::taa) > 0;
      if (known || refusal(settings) || !settings.taa.policy.needs_history()) continue;
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
  constexpr uint32_t seeds = 50, frames = 4; // 200 pictures
  std::vector<ModeRun> runs;
  for (const TaaMode& mode : taa_modes())
    for (const Resolver resolver : {Resolver::fast, Resolver::naive}) {
      if (!mode.settings.policy.needs_history()) continue;
      runs.push_back(run_of(mode.name));
      runs.back().taa.resolver = resolver;
    }
  for (uint32_t seed = 0; seed < seeds; ++seed) {
    std::mt19937 random(seed);
    for (uint32_t frame = 0; frame < frames; ++frame) {
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

/// The colours of a pixel and its neighbours, the edge going on.
std::array<glm::dvec3, 9> neighbours_of(const Inputs& inputs, size_t pixel) {
  const int x = int(pixel % inputs.width), y = int(pixel / inputs.width);
  std::array<glm::dvec3, 9> colours;
  for (int k = 0; k < 9; ++k) {
    const int u = std::clamp(x + k % 3 - 1, 0, int(inputs.width) - 1);
    const int v = std::clamp(y + k / 3 - 1, 0, int(inputs.height) - 1);
    colours[size_t(k)] = inputs.colours[size_t(v) * inputs.width + size_t(u)];
  }
  return colours;
}

Inputs random_colours(std::mt19937& random) {
  Inputs inputs(24, 24);
  for (glm::vec3& colour : inputs.colours)
    colour = half({any_number(random, false), any_number(random, false), any_number(random, false)});
  return inputs;
}

/// How far a colour lies outside of the convex hull of nine: negative inside. The hull's faces are those
/// planes through three of the points that have all of them on one side.
double outside_of_hull(const std::array<glm::dvec3, 9>& points, glm::dvec3 colour) {
  double most = -1e30;
  for (size_t a = 0; a < 9; ++a)
    for (size_t b = a + 1; b < 9; ++b)
      for (size_t c = b + 1; c < 9; ++c) {
        glm::dvec3 normal = glm::cross(points[b] - points[a], points[c] - points[a]);
        if (glm::length(normal) == 0) continue;
        normal = glm::normalize(normal);
        double low = 0, high = 0; // of all points, from the plane
        for (const glm::dvec3& point : points) {
          low = std::min(low, glm::dot(point - points[a], normal));
          high = std::max(high, glm::dot(point - points[a], normal));
        }
        const double rounding = 1e-12 * glm::length(points[a]), at = glm::dot(colour - points[a], normal);
        if (high <= rounding) most = std::max(most, at);
        if (-low <= rounding) most = std::max(most, -at);
      }
  return most;
}

glm::dvec3 ycocg(glm::dvec3 c) {
  return {(c.x + 2 * c.y + c.z) / 4, (c.x - c.z) / 2, (2 * c.y - c.x - c.z) / 4};
}

/// What bounds a history in plain double precision: the box of nine colours, or of their mean and standard
/// deviation.
Bounds volume_of(const std::array<glm::dvec3, 9>& colours, bool variance) {
  glm::dvec3 low(1e30), high(-1e30), mean(0), squares(0);
  for (const glm::dvec3& colour : colours) {
    low = glm::min(low, colour), high = glm::max(high, colour);
    mean += colour / 9.0;
  }
  if (!variance) return {low, high};
  for (const glm::dvec3& colour : colours) squares += (colour - mean) * (colour - mean) / 9.0;
  return {mean - glm::sqrt(squares), mean + glm::sqrt(squares)};
}

bool holds(const Bounds& box, glm::dvec3 colour, double error) {
  return glm::all(glm::greaterThanEqual(colour, glm::dvec3(box.low) - error)) &&
         glm::all(glm::lessThanEqual(colour, glm::dvec3(box.high) + error));
}

struct RectifiedAs {
  const char* mode;
  bool in_ycocg, variance,
      clips;           // along the segment to the current colour, which may lie outside of a variance's box
  bool is_box, in_box; // the volume is the box; it lies in it, having the box's axes among its own
};
constexpr RectifiedAs rectifications[] = {
    {"gdk-clamp", false, false, false, true, true}, {"gdk-variance", false, true, false, true, true},
    {"gdk-clip", false, false, true, true, true},   {"rgb", false, false, true, true, true},
    {"ycocg", true, false, true, true, true},       {"rgb-var", false, true, true, true, true},
    {"ycocg-var", true, true, true, true, true},    {"dop32", false, false, true, false, true},
    {"dop32-var", false, true, true, false, true},  {"dop16-opt", false, false, true, false, false},
};

// In its volume, on its segment, and what is inside as it was to the bit.
TEST_F(HandMade, ARectifiedHistoryLiesInItsVolumeAndOnItsSegment) {
  std::mt19937 random(7);
  const Inputs history = random_colours(random), now = random_colours(random);
  for (const RectifiedAs& as : rectifications) {
    const std::vector<glm::vec3> results = rectified(bench, as.mode, history, now);
    size_t unchanged = 0, moved = 0;
    for (size_t i = 0; i < results.size(); ++i) {
      const glm::dvec3 h(history.colours[i]), c(now.colours[i]), r(results[i]);
      const auto working = [&](glm::dvec3 colour) { return as.in_ycocg ? ycocg(colour) : colour; };
      std::array<glm::dvec3, 9> colours = neighbours_of(now, i);
      for (glm::dvec3& colour : colours) colour = working(colour);
      Bounds volume = volume_of(colours, as.variance);
      if (as.clips)
        volume.low = glm::min(volume.low, glm::vec3(working(c))),
        volume.high = glm::max(volume.high, glm::vec3(working(c)));
      const double error = 2e-3 * glm::length(glm::max(h, c)); // what two half floats are apart
      if (as.clips) {
        const double along = glm::dot(r - c, h - c) / std::max(glm::dot(h - c, h - c), 1e-30);
        EXPECT_LT(glm::distance(r, c + std::clamp(along, 0.0, 1.0) * (h - c)), error) << as.mode << i;
      }
      if (as.in_box) {
        EXPECT_TRUE(holds(volume, working(r), error)) << as.mode << i;
      }
      // YCoCg and back is exact but for float's rounding, which a half float forgets
      if (as.is_box && holds(volume, working(h), -1e-5 * glm::length(h))) {
        EXPECT_EQ(r, h) << as.mode << i;
      }
      (r == h ? unchanged : moved) += 1;
    }
    EXPECT_GT(unchanged, 10u) << as.mode;
    EXPECT_GT(moved, 10u) << as.mode;
  }
}

// The hull of the nine colours lies in the polytope, the polytope in the box: what lies in the smaller one,
// the larger leaves to the bit.
TEST_F(HandMade, VolumesNest) {
  std::mt19937 random(8);
  Inputs history = random_colours(random), now = random_colours(random);
  for (size_t i = 0; i < now.colours.size(); ++i) { // colours in the hull, and just outside
    const std::array<glm::dvec3, 9> around = neighbours_of(now, i);
    std::array<double, 9> shares;
    double sum = 0;
    for (double& share : shares) sum += share = -std::log(double(1 + random() % 1000) / 1001);
    glm::dvec3 mixed(0), mean(0);
    for (size_t k = 0; k < 9; ++k) mixed += around[k] * (shares[k] / sum), mean += around[k] / 9.0;
    history.colours[i] = half(glm::max(mean + (mixed - mean) * (i % 2 == 0 ? 1.0 : 2.0), 0.0));
  }
  const auto box = rectified(bench, "rgb", history, now), dop = rectified(bench, "dop32", history, now);
  size_t in_hull = 0, kept_by_dop = 0, kept_by_box = 0;
  for (size_t i = 0; i < box.size(); ++i) {
    const bool hulled = outside_of_hull(neighbours_of(now, i), history.colours[i]) < -1e-6;
    const bool in_dop = dop[i] == history.colours[i], in_box = box[i] == history.colours[i];
    EXPECT_TRUE(!hulled || in_dop) << i;
    EXPECT_TRUE(!in_dop || in_box) << i;
    in_hull += hulled, kept_by_dop += in_dop, kept_by_box += in_box;
  }
  EXPECT_GT(in_hull, 100u);
  EXPECT_LT(in_hull, kept_by_dop) << "each is tighter than the next";
  EXPECT_LT(kept_by_dop, kept_by_box);
}

// A polytope of three axes is the box.
TEST_F(HandMade, ThreeAxesAreTheBox) {
  std::mt19937 random(9);
  const Inputs history = random_colours(random), now = random_colours(random);
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
