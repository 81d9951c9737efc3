#include "app/rigs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/measure/results.h"

namespace unghost {
namespace {

using glm::dmat4, glm::dvec3, glm::dvec4, glm::radians;

constexpr double road_centre_m =
    1.8; // left of the path: the road reaches from 2.2 m right of it to 5.8 m left

/// What a seed changes.
struct Variation {
  double start_m = 0; // along the track
  double side = 1;    // -1: the camera stands on the right
  double sun_deg = 0;
  double pace = 1;
};

// splitmix64 (Steele, Lea and Flood 2014), as a number from 0 to 1.
double random_of(uint64_t seed, uint64_t which) {
  uint64_t z = seed * 0x9E3779B97F4A7C15u + (which + 1) * 0xD1B54A32D192ED03u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return double((z ^ (z >> 31)) >> 11) * 0x1.0p-53;
}

Variation variation_of(const RigContext& context) {
  if (context.seed == 1) return {};
  const auto random = [&](uint64_t which) { return random_of(context.seed, which); };
  return {.start_m = random(0) * 2 * std::numbers::pi * context.track_radius,
          .side = random(1) < 0.5 ? -1.0 : 1.0,
          .sun_deg = 40 * random(2) - 20,
          .pace = 0.9 + 0.2 * random(3)};
}

Bounds bounds_of(const RigContext& context) {
  if (!context.vehicle.empty()) return context.vehicle;
  const glm::vec3 half = glm::vec3(usual_car_m) / 2.0f;
  return {.low = {-half.x, 0, -half.z}, .high = {half.x, 2 * half.y, half.z}};
}

// How much larger than the usual car it is.
double scale_of(const Bounds& bounds) {
  const dvec3 ratio = dvec3(bounds.high - bounds.low) / usual_car_m;
  return std::max({ratio.x, ratio.y, ratio.z});
}

double heading_at(const RigContext& context, double arc_m) { return arc_m / context.track_radius; }

/// The frame (x left, y up, z forward) `arc_m` along the path and `left_m` beside it.
dmat4 frame_on_path(const RigContext& context, double arc_m, double left_m) {
  const double angle = heading_at(context, arc_m), radius = context.track_radius;
  const dvec3 left{std::cos(angle), 0, -std::sin(angle)}, forward{std::sin(angle), 0, std::cos(angle)};
  const dvec3 place = dvec3(radius, 0, 0) - (radius - left_m) * left;
  return {dvec4(left, 0), dvec4(0, 1, 0, 0), dvec4(forward, 0), dvec4(place, 1)};
}

/// One rig's answer, before it is put into the world.
struct Pose {
  dmat4 vehicle{1};
  double travelled_m = 0;
  dmat4 camera_frame{1}; // in which eye and target are given
  dvec3 eye{0}, target{0};
  double roll = 0;
  double vertical_fov = Instant{}.vertical_fov;
  double sun_azimuth_deg = 0; // from the path's direction at the start, towards the camera's side
};

dvec3 towards_sun(const RigContext& context, const Variation& variation, double azimuth_deg) {
  const double azimuth = heading_at(context, variation.start_m) +
                         variation.side * radians(azimuth_deg + context.light.sun_azimuth_deg) +
                         radians(variation.sun_deg);
  const double elevation = radians(double(context.light.sun_elevation_deg));
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
          std::cos(elevation) * std::cos(azimuth)};
}

Instant instant_of(const RigContext& context, const Variation& variation, const Pose& pose, double time_s) {
  const dvec3 eye = pose.camera_frame * dvec4(pose.eye, 1),
              target = pose.camera_frame * dvec4(pose.target, 1);
  const Bounds bounds = bounds_of(context);
  const double wheelbase_m = 0.6 * double(bounds.high.z - bounds.low.z);
  const glm::dquat upright = glm::quatLookAt(glm::normalize(target - eye), dvec3(0, 1, 0));
  return {.eye = eye,
          .camera = upright * glm::angleAxis(pose.roll, dvec3(0, 0, 1)),
          .vertical_fov = pose.vertical_fov,
          .near_plane = 0.1 * std::min(1.0, scale_of(bounds)),
          .vehicle = pose.vehicle,
          .wheel_travel = pose.travelled_m,
          .steer = std::atan(wheelbase_m / context.track_radius),
          .animation_s = time_s,
          .towards_sun = towards_sun(context, variation, pose.sun_azimuth_deg)};
}

double speed_of(const RigContext& context, const Variation& variation, double metres_per_second) {
  return metres_per_second * context.stage.speed * variation.pace *
         std::min(1.0, scale_of(bounds_of(context)));
}

/// A camera `distance_m` from the vehicle's middle, `angle` from its nose towards its left.
Pose parked(const RigContext& context, const Variation& variation, double angle,
            const dvec3& eye_and_target_height, double distance_m) {
  const double scale = scale_of(bounds_of(context));
  const dmat4 frame = frame_on_path(context, variation.start_m, road_centre_m);
  const dvec3 away{std::sin(angle), 0, std::cos(angle)};
  return {.vehicle = frame,
          .camera_frame = frame,
          .eye = scale * (distance_m * away + dvec3(0, eye_and_target_height.x, 0)),
          .target = scale * dvec3(0, eye_and_target_height.y, 0)};
}

Instant still(const RigContext& context, double time_s) {
  const Variation variation = variation_of(context);
  Pose pose = parked(context, variation, variation.side * radians(38.0), {1.35, 0.5, 0}, 6.2);
  pose.vertical_fov = 0.6;
  pose.sun_azimuth_deg = -75;
  return instant_of(context, variation, pose, time_s);
}

Instant rotate(const RigContext& context, double time_s) {
  const Variation variation = variation_of(context);
  const double turned_deg = 60.0 * context.stage.speed * variation.pace * time_s;
  Pose pose = parked(context, variation, variation.side * radians(200.0 - turned_deg), {1.6, 0.55, 0}, 6.5);
  pose.sun_azimuth_deg = -95;
  return instant_of(context, variation, pose, time_s);
}

// 30 m/s and a chase camera that sways a little, as one on a boom does.
Instant drive(const RigContext& context, double time_s) {
  const Variation variation = variation_of(context);
  const Bounds bounds = bounds_of(context);
  const double scale = scale_of(bounds), side = variation.side, tau = 2 * std::numbers::pi;
  const double travelled_m = speed_of(context, variation, 30) * time_s;
  const dmat4 frame = frame_on_path(context, variation.start_m + travelled_m, 0);
  const double sway = std::sin(0.7 * tau * time_s), bob = std::sin(1.3 * tau * time_s);
  const dvec3 eye{side * 0.9 + 0.03 * sway, 1.7 + 0.02 * bob, -5.5}, target{side * -0.1, 0.45, 6};
  return instant_of(context, variation,
                    {.vehicle = frame,
                     .travelled_m = travelled_m,
                     .camera_frame = frame,
                     .eye = scale * eye + dvec3(0, 0, bounds.low.z),
                     .target = scale * target + dvec3(0, 0, bounds.high.z),
                     .roll = 0.006 * sway,
                     .sun_azimuth_deg = -85},
                    time_s);
}

// The vehicle swings through the picture as a pendulum does, 10 m/s in the middle, so that a run of any
// length has it in view; it needs about 90 frames from one side to the other, is fast where a short
// measurement looks, and whole in the picture at the 64th. Where it does so no lamp throws a shadow on the
// road that could be taken for a trail.
Instant pass(const RigContext& context, double time_s) {
  const Variation variation = variation_of(context);
  const double scale = scale_of(bounds_of(context)), side = variation.side;
  const double reach_m = 5 * scale, phase = 0.1 + speed_of(context, variation, 10) / reach_m * time_s;
  const double along_m = -reach_m * std::cos(phase), middle_m = variation.start_m + 12;
  const double lane_m = side > 0 ? 0.0 : 1.9;     // the lane further from the camera
  const double camera_m = side > 0 ? 10.4 : -5.5; // in front of the guard rails, 11 m left and 6 m right
  const double distance_m = std::min(7.5 * scale, std::abs(camera_m - lane_m));
  return instant_of(
      context, variation,
      {.vehicle = frame_on_path(context, middle_m + along_m, lane_m),
       .travelled_m = along_m,
       .camera_frame = frame_on_path(context, middle_m, lane_m),
       .eye = {side * distance_m, 1.5 * scale, 0},
       .target = {0, 0.8 * scale, 0},
       .vertical_fov = 2 * std::atan(std::tan(Instant{}.vertical_fov / 2) * 7.5 * scale / distance_m),
       .sun_azimuth_deg = -95},
      time_s);
}

Instant overhead(const RigContext& context, double time_s) {
  const Variation variation = variation_of(context);
  const double scale = scale_of(bounds_of(context));
  const double travelled_m = speed_of(context, variation, 30) * time_s;
  const dmat4 frame = frame_on_path(context, variation.start_m + travelled_m, 0);
  return instant_of(context, variation,
                    {.vehicle = frame,
                     .travelled_m = travelled_m,
                     .camera_frame = frame,
                     .eye = scale * dvec3(variation.side * 1.5, 22, -8),
                     .target = scale * dvec3(variation.side * 0.5, 0, 1),
                     .sun_azimuth_deg = -95},
                    time_s);
}

} // namespace

std::span<const Rig> rigs() {
  static constexpr Rig rows[] = {
      {rest_rig, "Nothing moves: convergence and shimmer.", still},
      {"drive", "The vehicle drives fast and the camera chases it: the near road, the shadow behind.", drive},
      {"rotate", "The camera swings round the parked vehicle: disocclusion beside it.", rotate},
      {"pass",
       "The vehicle crosses the picture of a fixed camera: a trail and a moving shadow on ground that rests.",
       pass},
      {"overhead", "The vehicle drives, seen from far above: thresholds that no longer fit.", overhead},
  };
  return rows;
}

const Rig* find_rig(std::string_view name) {
  const auto found = std::ranges::find(rigs(), name, &Rig::name);
  return found == rigs().end() ? nullptr : &*found;
}

} // namespace unghost
