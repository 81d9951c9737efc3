#include "renderer/scene/animation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace unghost {

namespace {

/// The key at or before a time, and how far it is to the next one.
struct Moment {
  size_t key = 0;
  double part = 0;     // 0 to 1; 0 where there is no next key
  double interval = 0; // seconds between the two keys
};

Moment moment_at(std::span<const float> times, double seconds) {
  const auto after = std::upper_bound(times.begin(), times.end(), seconds);
  if (after == times.begin()) return {};
  const auto key = size_t(after - times.begin()) - 1;
  if (after == times.end()) return {.key = key};
  const double interval = double(*after) - double(times[key]);
  return {.key = key, .part = (seconds - double(times[key])) / interval, .interval = interval};
}

glm::dvec4 slerp_shortest(glm::dvec4 a, glm::dvec4 b, double part) {
  double cosine = glm::dot(a, b);
  if (cosine < 0) b = -b, cosine = -cosine;
  if (cosine > 0.9999999) return glm::mix(a, b, part); // the sine below would vanish
  const double angle = std::acos(cosine);
  return (std::sin((1 - part) * angle) * a + std::sin(part * angle) * b) / std::sin(angle);
}

/// glTF 2.0, appendix C.4.4. Values stand as in-tangent, value, out-tangent.
glm::dvec4 cubic(const AnimationTrack& track, const Moment& at) {
  const glm::dvec4 value(track.values[at.key * 3 + 1]);
  if (at.part == 0) return value;
  const glm::dvec4 leaves = glm::dvec4(track.values[at.key * 3 + 2]) * at.interval;
  const glm::dvec4 arrives = glm::dvec4(track.values[at.key * 3 + 3]) * at.interval;
  const glm::dvec4 next(track.values[at.key * 3 + 4]);
  const double t = at.part, t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * value + (t3 - 2 * t2 + t) * leaves + (3 * t2 - 2 * t3) * next +
         (t3 - t2) * arrives;
}

glm::dvec4 value_at(const AnimationTrack& track, double seconds) {
  const Moment at = moment_at(track.times, seconds);
  if (track.interpolation == Interpolation::cubic_spline) return cubic(track, at);
  const glm::dvec4 value(track.values[at.key]);
  if (track.interpolation == Interpolation::step || at.part == 0) return value;
  const glm::dvec4 next(track.values[at.key + 1]);
  return track.channel == Channel::rotation ? slerp_shortest(value, next, at.part)
                                            : glm::mix(value, next, at.part);
}

} // namespace

std::vector<Trs> default_pose(const Scene& scene) {
  std::vector<Trs> local;
  local.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) local.push_back(node.local);
  return local;
}

void sample(const Animation& animation, double seconds, std::span<Trs> local) {
  for (const AnimationTrack& track : animation.tracks) {
    const glm::dvec4 value = value_at(track, seconds);
    Trs& trs = local[size_t(track.node)];
    if (track.channel == Channel::translation) trs.translation = glm::vec3(value);
    if (track.channel == Channel::scale) trs.scale = glm::vec3(value);
    if (track.channel != Channel::rotation) continue;
    const double length = glm::length(value);
    const glm::dvec4 unit = length > 0 ? value / length : glm::dvec4(0, 0, 0, 1);
    trs.rotation = glm::quat(float(unit.w), float(unit.x), float(unit.y), float(unit.z));
  }
}

glm::dmat4 matrix_of(const Trs& local) {
  const glm::dmat3 rotation = glm::mat3_cast(glm::normalize(glm::dquat(local.rotation)));
  const glm::dvec3 scale(local.scale);
  return {glm::dvec4(rotation[0] * scale.x, 0), glm::dvec4(rotation[1] * scale.y, 0),
          glm::dvec4(rotation[2] * scale.z, 0), glm::dvec4(glm::dvec3(local.translation), 1)};
}

std::vector<glm::dmat4> world_matrices(const Scene& scene, std::span<const Trs> local) {
  assert(local.size() == scene.nodes.size());
  std::vector<glm::dmat4> world(scene.nodes.size());
  for (size_t i = 0; i < world.size(); ++i) {
    const Node& node = scene.nodes[i];
    const glm::dmat4 own = node.matrix ? glm::dmat4(*node.matrix) : matrix_of(local[i]);
    world[i] = node.parent < 0 ? own : world[size_t(node.parent)] * own;
  }
  return world;
}

} // namespace unghost
