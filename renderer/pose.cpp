#include "renderer/pose.h"

#include <cmath>

#include "renderer/scene/animation.h"
#include "renderer/scene/bounds.h"

namespace unghost {
namespace {

bool is_animated(const Scene& scene, int node) {
  for (const Animation& animation : scene.animations)
    for (const AnimationTrack& track : animation.tracks)
      if (track.node == node) return true;
  return false;
}

/// A wheel that the file animates by itself is left alone.
void turn_wheels(const Scene& scene, const Instant& instant, const std::vector<glm::dmat4>& world,
                 std::vector<Trs>& local) {
  for (size_t n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.wheel || node.wheel->radius <= 0 || is_animated(scene, int(n))) continue;
    const double scale = node.parent < 0 ? 1.0 : glm::length(glm::dvec3(world[size_t(node.parent)][1]));
    const double radius = std::max(double(node.wheel->radius) * scale, 1e-3);
    const double turns = std::fmod(instant.wheel_travel / radius, 2 * 3.14159265358979323846);
    const glm::dquat roll = glm::angleAxis(turns, glm::dvec3(1, 0, 0));
    const glm::dquat steer = glm::angleAxis(node.wheel->steers ? instant.steer : 0.0, glm::dvec3(0, 1, 0));
    local[n].rotation = glm::quat(steer * glm::dquat(node.local.rotation) * roll);
  }
}

} // namespace

std::vector<glm::dmat4> pose(const Scene& scene, const Instant& instant) {
  std::vector<Trs> local = default_pose(scene);
  if (!scene.animations.empty() && scene.animations.front().duration > 0)
    sample(scene.animations.front(),
           std::fmod(instant.animation_s, double(scene.animations.front().duration)), local);
  std::vector<glm::dmat4> world = world_matrices(scene, local);
  turn_wheels(scene, instant, world, local);
  world = world_matrices(scene, local);
  if (scene.vehicle < 0) return world;
  // wherever the file has parked it: the rig says where the vehicle's own frame is
  const glm::dmat4 parked = world_matrices(scene, default_pose(scene))[size_t(scene.vehicle)];
  const glm::dmat4 moves = instant.vehicle * glm::inverse(parked);
  const std::vector<bool> in_vehicle = subtree_of(scene, scene.vehicle);
  for (size_t n = 0; n < world.size(); ++n)
    if (in_vehicle[n]) world[n] = moves * world[n];
  return world;
}

} // namespace unghost
