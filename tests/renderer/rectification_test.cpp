// Rectifications as functions, against plain double precision.
#include <algorithm>
#include <array>

#include "app/measure/rectification.h"
#include "renderer/settings.h"
#include "tests/renderer/resolve_bench.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

using Rectifications = ResolveBenchTest;

/// With a weight of 0 and no motion the result is the rectified history.
std::vector<glm::vec3> rectified(ResolveBench& bench, std::string_view mode, const Inputs& history,
                                 const Inputs& now) {
  ModeRun run = run_of(mode);
  run.taa.alpha = 0;
  run.taa.policy.history = HistoryFilter::nearest;
  run.taa.policy.dilation = Dilation::centre;
  run.taa.policy.input = Input::sampled;
  if (run.taa.policy.blend == Blend::speed) run.taa.policy.blend = Blend::constant; // alpha is its least
  bench.resolve(history, {run}, true);
  return bench.resolve(now, {run}, false)[0];
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

/// Of one mode, at every pixel: in its volume; on the segment from the current colour, and as far along it as
/// the volume reaches; and what is inside as it was to the bit.
void expect_rectified(const TaaMode& mode, const Inputs& history, const Inputs& now,
                      const std::vector<glm::vec3>& results) {
  const TaaPolicy& policy = mode.settings.policy;
  const auto working = [&](glm::dvec3 colour) { return to_working(policy, colour); };
  size_t unchanged = 0, moved = 0;
  for (size_t i = 0; i < results.size(); ++i) {
    const glm::dvec3 h(history.colours[i]), c(now.colours[i]), r(results[i]);
    std::array<glm::dvec3, 9> colours = neighbours_of(now, i);
    for (glm::dvec3& colour : colours) colour = working(colour);
    const std::vector<Slab> volume = volume_of(colours, policy, double(mode.settings.gamma));
    const double error = 2e-3 * glm::length(glm::max(h, c)); // what two half floats are apart
    EXPECT_LT(outside_of(volume, working(r)), error) << mode.name << i;
    if (outside_of(volume, working(h)) < -1e-5 * glm::length(h)) {
      EXPECT_EQ(r, h) << mode.name << i;
    }
    if (policy.rectify != Rectify::box_clamp && policy.rectify != Rectify::variance_clamp) {
      const double along = glm::dot(r - c, h - c) / std::max(glm::dot(h - c, h - c), 1e-30);
      EXPECT_LT(glm::distance(r, c + std::clamp(along, 0.0, 1.0) * (h - c)), error) << mode.name << i;
    }
    if (r != h) {
      EXPECT_GT(outside_of(volume, working(r)), -error) << mode.name << i;
    }
    (r == h ? unchanged : moved) += 1;
  }
  EXPECT_GT(unchanged, 5u) << mode.name;
  EXPECT_GT(moved, 10u) << mode.name;
}

TEST_F(Rectifications, LieInTheirVolumeAndOnTheirSegment) {
  std::mt19937 random(7);
  const Inputs history = random_colours(random), now = random_colours(random);
  size_t tested = 0;
  for (const TaaMode& mode : taa_modes()) {
    const TaaPolicy& policy = mode.settings.policy;
    if (policy.rectify == Rectify::none || policy.weighting != Weighting::none) continue;
    if (policy.where != Where::everywhere) continue; // as the same row that has it everywhere
    expect_rectified(mode, history, now, rectified(bench, mode.name, history, now));
    ++tested;
  }
  EXPECT_GE(tested, 12u);
}

// Clamped channel by channel where bright colours weigh less, the blue of one neighbour would meet the red of
// another.
TEST_F(Rectifications, MakeNothingBrighterThanWhatItIsMadeFrom) {
  Inputs history(16, 16), now(16, 16);
  for (size_t i = 0; i < now.colours.size(); ++i) {
    now.colours[i] = i % 2 == 0 ? glm::vec3(10, 0, 29.4f) : glm::vec3(0, 2.98f, 29.4f);
    history.colours[i] = {10, 2.98f, 0};
  }
  for (const Resolver resolver : {Resolver::fast, Resolver::naive}) {
    ModeRun run = run_of("holy-trail");
    run.taa.alpha = 0, run.taa.resolver = resolver;
    bench.resolve(history, {run}, true);
    const auto results = bench.resolve(now, {run}, false);
    for (const glm::vec3& colour : results[0])
      EXPECT_LT(glm::dot(colour, glm::vec3(0.2126f, 0.7152f, 0.0722f)), 4.5f);
  }
}

// The hull of the nine colours lies in the polytope, the polytope in the box: what lies in the smaller one,
// the larger leaves to the bit.
TEST_F(Rectifications, VolumesNest) {
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
TEST_F(Rectifications, ThreeAxesAreTheBox) {
  std::mt19937 random(9);
  const Inputs history = random_colours(random), now = random_colours(random);
  ModeRun box = run_of("rgb"), axes = run_of("dop32");
  axes.taa.policy.axes = Axes::xyz;
  bench.resolve(history, {box, axes}, true);
  const auto results = bench.resolve(now, {box, axes}, false);
  EXPECT_EQ(results[0], results[1]);
}

} // namespace
} // namespace unghost
