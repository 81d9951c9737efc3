#include "app/measure/axes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "renderer/settings.h"

namespace unghost {
namespace {

constexpr auto quietly = [](double) {};

std::vector<glm::dvec3> around_sphere(size_t count, uint64_t seed = 1) {
  return find_axes(
             {.count = count, .seed = seed, .steps = 24'000},
             [](std::span<const glm::dvec3> axes) { return volume_around_sphere(axes); }, quietly)
      .axes;
}

TEST(Axes, VolumeOfKnownPolytopes) {
  const std::vector<glm::dvec3> cube = shipped_axes("xyz");
  EXPECT_NEAR(volume_around_sphere(cube), 6 / std::numbers::pi, 1e-3);
  const double h = 1 / std::sqrt(3.0);
  const std::vector<glm::dvec3> octahedron = {{h, h, h}, {h, h, -h}, {h, -h, h}, {-h, h, h}};
  EXPECT_NEAR(volume_around_sphere(octahedron), 3 * std::sqrt(3.0) / std::numbers::pi, 2e-3);
}

TEST(Axes, AroundTheSphereAreNoWorseThanThePapers) {
  EXPECT_LE(volume_around_sphere(around_sphere(16)), volume_around_sphere(shipped_axes("dop32")));
  // none of the paper's sixteen faces was found for a sphere; ours, and with X, Y and Z among them, is far
  // below them
  EXPECT_LE(volume_around_sphere(around_sphere(8)), 0.98 * volume_around_sphere(shipped_axes("dop16-grass")));
}

TEST(Axes, ShippedOnesAreWhatTheSearchFinds) {
  const std::vector<glm::dvec3> found = around_sphere(8), shipped = shipped_axes("dop16");
  ASSERT_EQ(found.size(), shipped.size());
  for (size_t i = 0; i < found.size(); ++i) EXPECT_LT(glm::distance(found[i], shipped[i]), 1e-5) << i;
}

TEST(Axes, EveryListHasUnitAxesAndTwiceAsManyFaces) {
  for (const Answer& answer : answers<Axes>()) {
    const std::vector<glm::dvec3> axes = shipped_axes(answer.name);
    ASSERT_FALSE(axes.empty()) << answer.name;
    for (const glm::dvec3& axis : axes) EXPECT_NEAR(glm::length(axis), 1, 2e-6) << answer.name;
    const size_t digits = answer.name.find_first_of("0123456789");
    if (digits != std::string::npos) {
      EXPECT_EQ(2 * axes.size(), std::stoul(answer.name.substr(digits))) << answer.name;
    }
  }
}

TEST(Axes, MoreAxesAreNeverLooser) {
  Neighbourhood colours, flat;
  for (size_t i = 0; i < 9; ++i) {
    colours[i] = {0.1 * double(i), 0.02 * double(i * i % 7), 0.05 * double(i * 5 % 9)};
    flat[i] = {colours[i].x, colours[i].y, 0.3};
  }
  std::vector<glm::dvec3> axes = shipped_axes("xyz");
  double before = size_around(axes, std::vector{colours});
  const double of_box = before;
  EXPECT_GT(of_box, 0.1);
  for (const glm::dvec3& axis : shipped_axes("dop32")) {
    axes.push_back(axis);
    const double after = size_around(axes, std::vector{colours});
    EXPECT_LE(after, before);
    before = after;
  }
  EXPECT_LT(before, 0.9 * of_box);
  EXPECT_EQ(size_around(axes, std::vector{flat}), 0) << "a plane of one blue has no volume";
}

} // namespace
} // namespace unghost
