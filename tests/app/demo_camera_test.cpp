#include "app/demo/camera.h"

#include <numbers>

#include <gtest/gtest.h>

#include "app/rigs.h"

namespace unghost {
namespace {

using glm::dquat, glm::dvec2, glm::dvec3;

constexpr double tiny = 1e-9, quarter_turn = std::numbers::pi / 2;

Instant rig_at(std::string_view name, double time_s = 0.7) { return find_rig(name)->at({}, time_s); }

std::vector<Instant> instants() {
  std::vector<Instant> all;
  for (const Rig& rig : rigs())
    for (const double time_s : {0.0, 0.4, 3.7})
      for (const uint64_t seed : {1, 2, 3}) all.push_back(rig.at({.seed = seed}, time_s));
  return all;
}

dvec3 pivot_of(const Instant& rig) { return dvec3(rig.vehicle[3]) + dvec3(0, 1, 0); }

/// Where the camera sees the vehicle: right, up, towards the camera.
dvec3 vehicle_in_view(const Instant& seen) { return glm::inverse(seen.camera) * (pivot_of(seen) - seen.eye); }

dvec3 right_of(const Instant& seen) { return seen.camera * dvec3(1, 0, 0); }
dvec3 up_of(const Instant& seen) { return seen.camera * dvec3(0, 1, 0); }
dvec3 forward_of(const Instant& seen) { return seen.camera * dvec3(0, 0, -1); }

CameraOffset steered(const CameraInput& input, const Instant& rig, double seconds = 1.0 / 60) {
  CameraOffset offset;
  steer(offset, input, rig, seconds);
  return offset;
}

Instant seen_by(const CameraInput& input, const Instant& rig, double seconds = 1.0 / 60) {
  return with_camera(steered(input, rig, seconds), rig);
}

TEST(DemoCamera, UntouchedItIsTheRigsToTheBit) {
  for (const Instant& rig : instants()) {
    EXPECT_TRUE(seen_by({}, rig) == rig);
    EXPECT_EQ(steered({}, rig), CameraOffset{});
  }
}

TEST(DemoCamera, ChangesNothingButTheCamera) {
  for (const Instant& rig : instants())
    for (const CameraInput& input :
         {CameraInput{.orbit = {1, 0.2}, .pan = {0.1, 0.1}, .zoom = 2}, CameraInput{.fly = {1, 0, 1}}}) {
      Instant seen = seen_by(input, rig);
      EXPECT_FALSE(seen == rig);
      seen.eye = rig.eye;
      seen.camera = rig.camera;
      EXPECT_TRUE(seen == rig);
    }
}

TEST(DemoCamera, OrbitingKeepsTheVehicleWhereItIsInThePicture) {
  for (const Instant& rig : instants())
    for (const dvec2 orbit : {dvec2(0.5, 0), dvec2(-3, 0.3), dvec2(2, -0.4), dvec2(0, 9)}) {
      const Instant seen = seen_by({.orbit = orbit}, rig);
      EXPECT_LT(glm::distance(vehicle_in_view(seen), vehicle_in_view(rig)), tiny);
      EXPECT_NEAR(glm::length(seen.camera), 1, tiny);
    }
}

TEST(DemoCamera, OrbitingDoesNotTiltTheHorizon) {
  for (Instant rig : instants()) {
    rig.camera = glm::quatLookAt(forward_of(rig), dvec3(0, 1, 0)); // without the rig's own sway
    const Instant seen = seen_by({.orbit = {2, 0.4}}, rig);
    EXPECT_NEAR(right_of(seen).y, 0, tiny);
  }
}

TEST(DemoCamera, OrbitsToItsRightAndUp) {
  const Instant rig = rig_at("still");
  const dvec3 right = seen_by({.orbit = {0.1, 0}}, rig).eye - rig.eye;
  EXPECT_GT(glm::dot(right, right_of(rig)), 0);
  EXPECT_NEAR(right.y, 0, tiny);
  EXPECT_GT(seen_by({.orbit = {0, 0.1}}, rig).eye.y, rig.eye.y);
}

TEST(DemoCamera, NeverTurnsOver) {
  for (const Instant& rig : instants())
    for (const double pitch : {1.5, 3.0, 100.0, -1.5, -3.0, -100.0}) {
      EXPECT_GT(up_of(seen_by({.orbit = {1, pitch}}, rig)).y, 0);
      for (const Instant& other : instants())
        EXPECT_GT(up_of(with_camera({.pitch = pitch}, other)).y, 0); // kept from rig to rig
    }
}

TEST(DemoCamera, ComesBackFromTheSteepestAtOnce) {
  const Instant rig = rig_at("drive");
  for (const double far : {50.0, -50.0}) {
    CameraOffset offset = steered({.orbit = {0, far}}, rig);
    const double steepest = forward_of(with_camera(offset, rig)).y;
    EXPECT_GT(std::abs(steepest), 0.99);
    steer(offset, {.orbit = {0, -std::copysign(0.3, far)}}, rig, 0);
    EXPECT_LT(std::abs(forward_of(with_camera(offset, rig)).y), std::sin(quarter_turn - 0.25));
  }
}

TEST(DemoCamera, ZoomsByATenthAStep) {
  for (const Instant& rig : instants()) {
    const Instant nearer = seen_by({.zoom = 1}, rig), farther = seen_by({.zoom = -2}, rig);
    EXPECT_LT(glm::distance(vehicle_in_view(nearer), 0.9 * vehicle_in_view(rig)), tiny);
    EXPECT_LT(glm::distance(vehicle_in_view(farther), vehicle_in_view(rig) / 0.81), tiny);
  }
}

TEST(DemoCamera, ZoomsNoNearerThanAFifthAndNoFartherThanEightTimes) {
  const Instant rig = rig_at("pass");
  EXPECT_EQ(steered({.zoom = 1000}, rig).distance, 0.2);
  EXPECT_EQ(steered({.zoom = -1000}, rig).distance, 8);
  EXPECT_EQ(steered({.zoom = -1e9}, rig).distance, 8);
}

TEST(DemoCamera, PansBySharesOfThePicture) {
  const Instant rig = rig_at("still");
  const double half = std::tan(rig.vertical_fov / 2);
  const dvec3 before = vehicle_in_view(rig), after = vehicle_in_view(seen_by({.pan = {0.25, 0.1}}, rig));
  EXPECT_NEAR((before.x / -before.z - after.x / -after.z) / (2 * half), 0.25, 0.005);
  EXPECT_NEAR((before.y / -before.z - after.y / -after.z) / (2 * half), 0.1, 0.005);
  EXPECT_NEAR(before.z, after.z, tiny);
  const Instant seen = seen_by({.pan = {0.25, 0.1}}, rig);
  EXPECT_LT(glm::length(seen.camera - rig.camera), tiny);
}

TEST(DemoCamera, PansByMetresThatFollowTheZoom) {
  const Instant rig = rig_at("still");
  CameraOffset near = steered({.zoom = 10}, rig);
  steer(near, {.pan = {0.1, 0}}, rig, 0);
  EXPECT_NEAR(near.pan.x / steered({.pan = {0.1, 0}}, rig).pan.x, std::pow(0.9, 10), tiny);
}

TEST(DemoCamera, FollowsTheRigUntilItFlies) {
  CameraOffset offset = steered({.orbit = {1, 0.2}, .zoom = 3}, rig_at("drive", 0));
  const Instant later = with_camera(offset, rig_at("drive", 1));
  EXPECT_GT(glm::distance(later.eye, with_camera(offset, rig_at("drive", 0)).eye), 20);
  steer(offset, {.fly = {0, 0, 1}}, rig_at("drive", 1), 0);
  EXPECT_EQ(with_camera(offset, rig_at("drive", 1)).eye, with_camera(offset, rig_at("drive", 2)).eye);
}

TEST(DemoCamera, FliesFromWhereItIsWithoutAJump) {
  for (const Instant& rig : instants()) {
    CameraOffset offset = steered({.orbit = {1, 0.1}, .pan = {0.1, 0}, .zoom = 3}, rig);
    const Instant before = with_camera(offset, rig);
    steer(offset, {.fly = {0, 0, 1}}, rig, 0);
    ASSERT_TRUE(offset.flown);
    EXPECT_LT(glm::distance(with_camera(offset, rig).eye, before.eye), tiny);
    EXPECT_LT(glm::length(with_camera(offset, rig).camera - before.camera), tiny);
  }
}

TEST(DemoCamera, FliesFourMetresASecond) {
  const Instant rig = rig_at("drive");
  const auto flown = [&](const dvec3& way, double fast) {
    return seen_by({.fly = way, .fast = fast}, rig, 0.5).eye - rig.eye;
  };
  EXPECT_LT(glm::distance(flown({0, 0, 1}, 1), 2.0 * forward_of(rig)), tiny);
  EXPECT_LT(glm::distance(flown({1, 0, 0}, 1), 2.0 * right_of(rig)), tiny);
  EXPECT_LT(glm::distance(flown({0, 1, 0}, 1), 2.0 * up_of(rig)), tiny);
  EXPECT_LT(glm::distance(flown({0, 0, -1}, 5), -10.0 * forward_of(rig)), tiny);
  EXPECT_LT(glm::distance(flown({0, 0, 0.25}, 1), 0.5 * forward_of(rig)), tiny); // a stick, part of its way
  EXPECT_NEAR(glm::length(flown({1, 1, 1}, 1)), 2, tiny);                        // askew is no faster
}

TEST(DemoCamera, LooksRoundWhileFlying) {
  const Instant rig = rig_at("still");
  const Instant flown = seen_by({.fly = {0, 0, 1}}, rig, 0);
  const Instant right = seen_by({.fly = {0, 0, 1}, .look = {0.2, 0}}, rig, 0);
  EXPECT_GT(glm::dot(forward_of(right), right_of(flown)), 0.15);
  EXPECT_NEAR(forward_of(right).y, forward_of(flown).y, tiny);
  EXPECT_GT(forward_of(seen_by({.fly = {0, 0, 1}, .look = {0, 0.2}}, rig, 0)).y, forward_of(flown).y);
  EXPECT_EQ(steered({.look = {1, 1}}, rig), CameraOffset{}); // and not else
}

TEST(DemoCamera, LooksNeitherOverNorUnder) {
  for (const Instant& rig : instants())
    for (const double pitch : {1.6, 50.0, -1.6, -50.0}) {
      CameraOffset offset = steered({.fly = {0, 0, 1}, .look = {0.3, pitch}}, rig);
      for (int i = 0; i < 5; ++i) steer(offset, {.look = {0.5, pitch}}, rig, 0.01);
      const Instant seen = with_camera(offset, rig);
      EXPECT_GT(up_of(seen).y, 0);
      EXPECT_GT(forward_of(seen).y * pitch, 0.9 * std::abs(pitch));
      EXPECT_NEAR(glm::length(seen.camera), 1, tiny);
    }
}

TEST(DemoCamera, WhatFliesIsNotTurnedAboutTheVehicle) {
  const Instant rig = rig_at("drive");
  CameraOffset offset = steered({.fly = {0, 0, 1}}, rig);
  const CameraOffset before = offset;
  steer(offset, {.orbit = {1, 1}, .pan = {1, 1}, .zoom = 3}, rig, 0.1);
  EXPECT_EQ(offset.yaw, before.yaw);
  EXPECT_EQ(offset.distance, before.distance);
  EXPECT_EQ(with_camera(offset, rig).eye, with_camera(before, rig).eye);
}

TEST(DemoCamera, StandsWhereARigLooksStraightDown) {
  Instant rig = rig_at("overhead");
  rig.camera = dquat(0.5, -0.5, 0.5, 0.5); // to the bit
  for (const double pitch : {0.0, 0.5, -0.5}) {
    const Instant seen = seen_by({.orbit = {0.3, pitch}}, rig);
    EXPECT_FALSE(glm::any(glm::isnan(seen.eye)));
    EXPECT_GE(up_of(seen).y, -tiny);
  }
}

} // namespace
} // namespace unghost
