// Motion where numbers are small, large, or far from the origin. All modes of a frame share it.
#include <cmath>

#include "app/interruption.h"
#include "app/measure/stability/block_world.h"
#include "app/measure/stability/matrix.h"
#include "app/measure/stability/motion_oracle.h"
#include "renderer/renderer.h"
#include "renderer/view.h"

namespace unghost {
namespace {

struct Extreme {
  const char* name;
  BlockWorld world;
  double near_plane = 0; // metres; 0: what suits the world
  double fov_deg = 45;
  bool turned = false; // the camera looked the other way before, and the block lay behind it
};

const std::vector<Extreme>& extremes() {
  static const std::vector<Extreme> all = {
      {"usual", {}},
      {"a scene of 1 mm, near plane 0.1 mm", {.side = 1e-3f}, 1e-4},
      {"a scene of 100 km, near plane 100 m", {.side = 1e5f}, 100},
      {"near plane 0.1 mm", {.side = 1}, 1e-4},
      {"a scene of 100 km, near plane 0.1 mm", {.side = 1e5f}, 1e-4},
      {"1,000 km from the origin", {.side = 1, .origin = {1e6f, 0, -1e6f}}},
      {"a field of view of 1 degree", {}, 0, 1},
      {"a field of view of 170 degrees", {}, 0, 170},
      {"1 degree, 1,000 km away", {.side = 1, .origin = {1e6f, 0, 0}}, 0, 1},
      {"what was behind the camera", {}, 0, 45, true}};
  return all;
}

Instant instant_of(const Extreme& extreme, glm::dvec3 moved) {
  Instant instant = block_instant(extreme.world, moved);
  if (extreme.near_plane > 0) instant.near_plane = extreme.near_plane;
  instant.vertical_fov = extreme.fov_deg * 3.14159265358979323846 / 180;
  return instant;
}

/// `drifts`: of the camera, and of the block, in sides of the block.
MotionDeviation deviation(StabilityBench& bench, const Extreme& extreme, double camera_drifts,
                          double block_drifts) {
  Renderer renderer(bench.device, bench.shaders, block_scene(extreme.world));
  const double side = double(extreme.world.side);
  FrameInput input;
  input.before = instant_of(extreme, {});
  input.now = instant_of(extreme, glm::dvec3(0.8, 0, 0.6) * block_drifts * side);
  input.now.eye += glm::dvec3(-0.6, 0.1, 0.8) * camera_drifts * side;
  if (extreme.turned) input.before.camera *= glm::angleAxis(3.0, glm::dvec3(0, 1, 0));
  input.index = 3, input.width = 128, input.height = 72;
  input.modes = {{.name = "blend", .taa = settings_for_mode("blend").taa}};
  input.wanted = {{Output::motion}, {Output::depth}, {Output::object}, {Output::previous_depth}};
  const FrameResult result = renderer.render(input);
  return motion_deviation(renderer.scene(), input, jitter_of(input.modes[0].taa, input),
                          {.motion = result.delivered[0].image,
                           .depth = result.delivered[1].image,
                           .object = result.delivered[2].image,
                           .previous_depth = result.delivered[3].image});
}

std::vector<Survival> survive(StabilityBench& bench, const char* what, double camera_drifts,
                              double block_drifts) {
  Survival survived;
  for (const Extreme& extreme : extremes()) {
    if (extreme.turned && camera_drifts == 0) continue;
    throw_if_interrupted();
    const MotionDeviation worst = deviation(bench, extreme, camera_drifts, block_drifts);
    worsen(survived, worst.surfaces > 0 || extreme.turned ? worst.motion_px : INFINITY,
           std::string(extreme.name) + ", " + what);
  }
  return {survived};
}

} // namespace

std::vector<Survival> survive_rest_in_extremes(StabilityBench& bench, std::span<const ModeRun>) {
  return survive(bench, "at rest", 0, 0);
}

std::vector<Survival> survive_motion_in_extremes(StabilityBench& bench, std::span<const ModeRun>) {
  std::vector<Survival> survived = survive(bench, "the camera moves", 0.02, 0);
  for (const Survival& one : survive(bench, "all moves", 0.02, 0.05))
    worsen(survived[0], one.figure, one.where);
  return survived;
}

} // namespace unghost
