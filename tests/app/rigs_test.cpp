#include "app/rigs.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <glm/gtc/matrix_inverse.hpp>
#include <gtest/gtest.h>

namespace unghost {
namespace {

using glm::dmat4, glm::dvec2, glm::dvec3, glm::dvec4;

constexpr double aspect = 16.0 / 9;

RigContext context_for(glm::vec3 size, uint64_t seed = 1) {
  RigContext context;
  context.seed = seed;
  context.vehicle = {.low = {-size.x / 2, 0, -size.z / 2}, .high = {size.x / 2, size.y, size.z / 2}};
  return context;
}

const glm::vec3 car{1.85f, 1.4f, 4.4f}, truck{2.5f, 3.4f, 10.0f}, toy{0.3f, 0.25f, 0.6f};

/// From -1 to 1 within the picture, y up; far outside where the point is behind the camera.
dvec2 projected(const Instant& instant, dvec3 world) {
  const dvec3 seen = glm::inverse(instant.camera) * (world - instant.eye);
  if (-seen.z < instant.near_plane) return {99, 99};
  const double tangent = std::tan(instant.vertical_fov / 2);
  return dvec2(seen.x / (-seen.z * tangent * aspect), seen.y / (-seen.z * tangent));
}

std::vector<dvec2> corners(const Instant& instant, const Bounds& bounds) {
  std::vector<dvec2> points;
  for (int i = 0; i < 8; ++i) {
    const dvec4 corner{i & 1 ? bounds.high.x : bounds.low.x, i & 2 ? bounds.high.y : bounds.low.y,
                       i & 4 ? bounds.high.z : bounds.low.z, 1};
    points.push_back(projected(instant, dvec3(instant.vehicle * corner)));
  }
  return points;
}

bool inside(dvec2 point) { return std::abs(point.x) < 1 && std::abs(point.y) < 1; }

TEST(Rigs, AreFoundByNameAndSummarised) {
  for (const Rig& rig : rigs()) {
    EXPECT_EQ(find_rig(rig.name)->at, rig.at);
    EXPECT_TRUE(rig.summary.ends_with('.'));
  }
  EXPECT_EQ(find_rig("drift"), nullptr);
}

TEST(Rigs, ArePureFunctionsOfTime) {
  const RigContext context = context_for(car, 7);
  for (const Rig& rig : rigs()) {
    const Instant first = rig.at(context, 0.5);
    rig.at(context, 9);
    const Instant again = rig.at(context, 0.5);
    EXPECT_EQ(std::memcmp(&first, &again, sizeof first), 0) << rig.name;
  }
}

// 30 m/s is half a metre a frame, and 60 degrees a second at 7 m an eighth.
TEST(Rigs, NeverJump) {
  for (const uint64_t seed : {1, 2, 3, 4, 5})
    for (const Rig& rig : rigs()) {
      const RigContext context = context_for(car, seed);
      Instant last = rig.at(context, 0);
      for (int frame = 1; frame < 600; ++frame) {
        const Instant now = rig.at(context, frame * seconds_per_frame);
        ASSERT_LT(glm::distance(now.eye, last.eye), 0.6) << rig.name << " " << frame;
        ASSERT_LT(glm::distance(dvec3(now.vehicle[3]), dvec3(last.vehicle[3])), 0.56)
            << rig.name << " " << frame;
        ASSERT_GT(std::abs(glm::dot(now.camera, last.camera)), std::cos(0.02)) << rig.name << " " << frame;
        ASSERT_EQ(now.towards_sun, last.towards_sun) << rig.name;
        last = now;
      }
    }
}

TEST(Rigs, KeepTheWholeVehicleInThePicture) {
  for (const glm::vec3 size : {car, truck, toy})
    for (const uint64_t seed : {1, 2, 3, 4})
      for (const char* name : {"still", "drive", "rotate", "overhead"})
        for (int frame = 0; frame < 400; frame += 7) {
          const RigContext context = context_for(size, seed);
          const auto points =
              corners(find_rig(name)->at(context, frame * seconds_per_frame), context.vehicle);
          ASSERT_TRUE(std::ranges::all_of(points, inside))
              << name << " " << size.z << " m, seed " << seed << " " << frame;
        }
}

TEST(Rigs, PassKeepsTheMiddleOfTheVehicleInThePictureAndCrossesIt) {
  for (const uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const RigContext context = context_for(car, seed);
    double least = 9, most = -9;
    for (int frame = 0; frame < 200; ++frame) {
      const Instant instant = find_rig("pass")->at(context, frame * seconds_per_frame);
      const dvec2 middle = projected(instant, dvec3(instant.vehicle * dvec4(0, 0.7, 0, 1)));
      ASSERT_TRUE(inside(middle)) << seed << " " << frame;
      if (frame < 90) least = std::min(least, middle.x), most = std::max(most, middle.x);
    }
    EXPECT_LT(least, -0.5) << seed;
    EXPECT_GT(most, 0.5) << seed;
  }
}

TEST(Rigs, PassHoldsTheCameraStill) {
  const RigContext context = context_for(car);
  const Instant first = find_rig("pass")->at(context, 0), later = find_rig("pass")->at(context, 0.4);
  EXPECT_EQ(first.eye, later.eye);
  EXPECT_EQ(first.camera, later.camera);
  EXPECT_NEAR(later.wheel_travel - first.wheel_travel, 2, 0.5);
}

// The guard rails stand 6 m right and 11 m left of the path.
TEST(Rigs, KeepTheCameraBetweenTheRails) {
  for (uint64_t seed = 1; seed < 20; ++seed)
    for (const Rig& rig : rigs())
      for (int frame = 0; frame < 400; frame += 11) {
        const RigContext context = context_for(car, seed);
        const Instant instant = rig.at(context, frame * seconds_per_frame);
        const double left_m =
            context.track_radius - std::hypot(instant.eye.x - context.track_radius, instant.eye.z);
        ASSERT_GT(left_m, -6) << rig.name << " " << seed << " " << frame;
        ASSERT_LT(left_m, 11) << rig.name << " " << seed << " " << frame;
      }
}

TEST(Rigs, DriveFollowsTheTrack) {
  const RigContext context = context_for(car);
  const Rig& drive = *find_rig("drive");
  EXPECT_EQ(dvec3(drive.at(context, 0).vehicle[3]), dvec3(0));
  for (const double time : {0.0, 1.0, 10.0}) {
    const Instant instant = drive.at(context, time);
    const dvec3 place(instant.vehicle[3]), ahead(drive.at(context, time + 1e-4).vehicle[3]);
    EXPECT_NEAR(glm::distance(place, dvec3(150, 0, 0)), 150, 1e-9);
    EXPECT_NEAR(glm::dot(glm::normalize(ahead - place), dvec3(instant.vehicle[2])), 1, 1e-6);
    EXPECT_NEAR(instant.wheel_travel, 30 * time, 1e-9);
    EXPECT_NEAR(glm::determinant(instant.vehicle), 1, 1e-9);
  }
  EXPECT_GT(drive.at(context, 1).vehicle[3].x, 0) << "the track curves to the left, which is +x";
  EXPECT_GT(drive.at(context, 0).steer, 0);
}

TEST(Rigs, SpeedScalesMotionAndZeroStopsIt) {
  RigContext context = context_for(car);
  context.stage.speed = 0.5f;
  EXPECT_NEAR(find_rig("drive")->at(context, 1).wheel_travel, 15, 1e-9);
  context.stage.speed = 0;
  for (const char* name : {"drive", "pass", "overhead", "rotate"}) {
    const Instant first = find_rig(name)->at(context, 0), later = find_rig(name)->at(context, 1);
    EXPECT_EQ(first.vehicle, later.vehicle) << name;
    EXPECT_LT(glm::distance(first.eye, later.eye), 0.1) << name;
  }
}

TEST(Rigs, SeedsDiffer) {
  const auto eye = [](const char* name, uint64_t seed) {
    return find_rig(name)->at(context_for(car, seed), 0.3).eye;
  };
  for (const Rig& rig : rigs())
    for (uint64_t a = 1; a < 8; ++a)
      for (uint64_t b = a + 1; b < 8; ++b)
        EXPECT_GT(glm::distance(eye(rig.name.data(), a), eye(rig.name.data(), b)), 0.5)
            << rig.name << a << " " << b;
}

// Where the shadow of the roof's middle falls lies on the camera's side, or at least in the picture.
TEST(Rigs, TheShadowIsInThePicture) {
  for (uint64_t seed = 1; seed < 10; ++seed)
    for (const Rig& rig : rigs()) {
      const Instant instant = rig.at(context_for(car, seed), 0.75);
      const dvec3 roof(instant.vehicle * dvec4(0, 1.4, 0, 1));
      const dvec3 shadow = roof - instant.towards_sun * (roof.y / instant.towards_sun.y);
      EXPECT_TRUE(inside(projected(instant, shadow))) << rig.name << " " << seed;
      EXPECT_NEAR(glm::length(instant.towards_sun), 1, 1e-9);
    }
}

} // namespace
} // namespace unghost
