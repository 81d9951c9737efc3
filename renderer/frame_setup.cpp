#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/frame.h"
#include "renderer/pose.h"
#include "renderer/scene/bounds.h"
#include "renderer/sun.h"
#include "renderer/view.h"

namespace unghost {
namespace {

glm::dmat4 relative_to(glm::dvec3 eye, glm::dmat4 world) {
  world[3] -= glm::dvec4(eye, 0);
  return world;
}

struct Objects {
  std::vector<glm::dmat4> eye_from_object;
  std::vector<glm::mat4x3> previous_eye_from_object;
  std::vector<uint8_t> moved, mirrored;
  bool anything_moved = false;
};

Objects place_objects(const FrameInput& input, const Scene& scene, const GpuScene& gpu,
                      const std::vector<glm::dmat4>& now) {
  const std::vector<glm::dmat4> before = pose(scene, input.before);
  Objects objects;
  for (const int node : gpu.object_nodes) {
    const glm::dmat4 eye_from_object = relative_to(input.now.eye, now[size_t(node)]);
    const bool moved = now[size_t(node)] != before[size_t(node)];
    objects.eye_from_object.push_back(eye_from_object);
    objects.moved.push_back(moved);
    objects.previous_eye_from_object.emplace_back(relative_to(input.before.eye, before[size_t(node)]));
    objects.mirrored.push_back(glm::determinant(glm::dmat3(eye_from_object)) < 0);
    objects.anything_moved |= moved;
  }
  return objects;
}

/// Whether some of the box may be seen: not all of its corners lie beyond one and the same side of the
/// picture.
bool may_be_seen(const Bounds& box, const glm::dmat4& clip_from_object, glm::dvec2 side = {1, 1}) {
  int beyond[5] = {};
  for (const glm::dvec4& corner : corners_of(box)) {
    const glm::dvec4 clip = clip_from_object * corner;
    beyond[0] += clip.x < -side.x * clip.w;
    beyond[1] += clip.x > side.x * clip.w;
    beyond[2] += clip.y < -side.y * clip.w;
    beyond[3] += clip.y > side.y * clip.w;
    beyond[4] += clip.z > clip.w; // before the near plane
  }
  for (const int count : beyond)
    if (count == 8) return false;
  return true;
}

/// From the camera to the sphere around the box, or less.
double distance_to(const Bounds& box, const glm::dmat4& eye_from_object) {
  const glm::dvec3 middle = eye_from_object * glm::dvec4(glm::dvec3(box.low + box.high) * 0.5, 1);
  const glm::dvec3 corner = eye_from_object * glm::dvec4(glm::dvec3(box.high), 1);
  return glm::length(middle) - glm::length(corner - middle);
}

/// The body's underside hides the sky from the road; wheels reach below it, bumpers and mirrors beyond.
void describe_underside(FrameConstants& constants, const FrameInput& input, const Bounds& vehicle) {
  constants.underside_half = glm::vec2(0);
  if (vehicle.empty()) return;
  const glm::dvec3 low(vehicle.low), high(vehicle.high), size = high - low, middle = (low + high) / 2.0;
  constexpr double clearance = 0.16, body = 0.9; // of its height; of its length and width
  const glm::dmat4 eye_from_vehicle = relative_to(input.now.eye, input.now.vehicle);
  const glm::dvec3 origin(middle.x, low.y + clearance * size.y, middle.z);
  constants.underside_from_eye =
      glm::dmat4x3(glm::inverse(eye_from_vehicle * glm::translate(glm::dmat4(1), origin)));
  constants.underside_half = glm::dvec2(size.x, size.z) / 2.0 * body;
}

/// Fills `visible` and `casters`.
void list_draws(FrameContext& in, const FrameConstants& constants, const GpuScene& gpu,
                const Objects& objects) {
  const glm::dmat4 clip_from_eye(constants.clip_from_eye);
  glm::dmat4 shadow_clip_from_eye(constants.shadow_from_eye);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 2; ++row)
      shadow_clip_from_eye[column][row] = 2 * shadow_clip_from_eye[column][row] - (column == 3 ? 1 : 0);
  // Culling does not see the jitter: it could move things by half a pixel.
  const glm::dvec2 side = 1.0 + 1.0 / glm::dvec2(constants.size_px);
  std::vector<std::pair<double, const Draw*>> by_distance;
  for (const Draw& draw : gpu.draws) {
    const glm::dmat4& eye_from_object = objects.eye_from_object[draw.object];
    if (may_be_seen(draw.bounds, clip_from_eye * eye_from_object, side))
      by_distance.emplace_back(distance_to(draw.bounds, eye_from_object), &draw);
    if ((draw.features & IS_UNLIT) == 0 && !draw.blended &&
        may_be_seen(draw.bounds, shadow_clip_from_eye * eye_from_object))
      in.casters.push_back(&draw);
  }
  // Pipelines change seldom, and within one near things come first, so that what lies behind them is not
  // shaded.
  std::ranges::stable_sort(by_distance, {},
                           [](const auto& one) { return std::pair(one.second->features, one.first); });
  for (const auto& [distance, draw] : by_distance) in.visible.push_back(draw);
}

std::vector<LightData> place_lights(const FrameInput& input, const Scene& scene,
                                    const std::vector<glm::dmat4>& now) {
  std::vector<LightData> lights;
  for (size_t n = 0; n < scene.nodes.size(); ++n) {
    if (scene.nodes[n].light < 0) continue;
    const Light& light = scene.lights[size_t(scene.nodes[n].light)];
    const glm::dmat4 eye_from_light = relative_to(input.now.eye, now[n]);
    LightData data{.position_eye = glm::vec3(eye_from_light[3]),
                   .inverse_range_squared = light.range > 0 ? 1 / (light.range * light.range) : 0,
                   .intensity = light.intensity,
                   .spot_scale = 0,
                   .direction_eye = glm::vec3(glm::normalize(-glm::dvec3(eye_from_light[2]))),
                   .spot_offset = 1,
                   .directional = light.kind == LightKind::directional};
    if (light.kind == LightKind::spot) {
      const float inner = std::cos(light.inner_cone), outer = std::cos(light.outer_cone);
      data.spot_scale = 1 / std::max(inner - outer, 1e-3f);
      data.spot_offset = -outer * data.spot_scale;
    }
    lights.push_back(data);
  }
  return lights;
}

/// Changes when the map moves, the sun does, or what rests is elsewhere or no longer rests.
uint64_t version_of(ShadowVersion& version, std::vector<double> place, const Objects& objects,
                    const GpuScene& gpu, const std::vector<glm::dmat4>& now) {
  for (size_t i = 0; i < objects.moved.size(); ++i) {
    place.push_back(objects.moved[i]);
    if (objects.moved[i]) continue;
    const glm::dmat4& world = now[size_t(gpu.object_nodes[i])];
    place.insert(place.end(), &world[0].x, &world[0].x + 16);
  }
  if (place != version.made_from) {
    version.made_from = std::move(place);
    ++version.number;
  }
  return version.number;
}

/// How deep what is tagged lies before the camera, and how far it reaches from one end to the other; zeros
/// where nothing is.
DepthRange tagged_range(const FrameInput& input, const GpuScene& gpu, const Objects& objects) {
  const glm::dvec3 ahead = input.now.camera * glm::dvec3(0, 0, -1);
  Bounds box;
  double deepest = 0;
  for (const Draw& draw : gpu.draws) {
    if (draw.tag == 0) continue;
    for (const glm::dvec4& corner : corners_of(draw.bounds)) {
      const glm::dvec3 eye = objects.eye_from_object[draw.object] * corner;
      deepest = std::max(deepest, glm::dot(eye, ahead));
      box.add(eye);
    }
  }
  if (box.empty()) return {};
  return {.deepest_m = float(deepest), .length_m = glm::length(box.high - box.low)};
}

bool share_geometry(const FrameInput& input, const TaaSettings& a, const TaaSettings& b) {
  if (a.mip_bias != b.mip_bias) return false;
  if (input.jitter_px) return a.texture_jitter == b.texture_jitter;
  const bool still = a.policy.jitter == Jitter::none || a.jitter_scale == 0;
  const bool other_still = b.policy.jitter == Jitter::none || b.jitter_scale == 0;
  return (still && other_still) || (!still && !other_still && a.policy.jitter == b.policy.jitter &&
                                    a.jitter_scale == b.jitter_scale && a.texture_jitter == b.texture_jitter);
}

/// By mode, whether its history is of another policy; `policies` become this frame's.
std::vector<uint8_t> changes_of(std::vector<TaaPolicy>& policies, const std::vector<ModeRun>& modes) {
  std::vector<uint8_t> changed;
  for (size_t i = 0; i < modes.size(); ++i)
    changed.push_back(i >= policies.size() || policies[i] != modes[i].taa.policy);
  policies.clear();
  for (const ModeRun& run : modes) policies.push_back(run.taa.policy);
  return changed;
}

/// For each mode the index of its geometry, and for each geometry the settings that its jitter comes from.
std::vector<const TaaSettings*> share_geometries(const FrameInput& input, std::vector<size_t>& geometry_of) {
  std::vector<const TaaSettings*> jitters;
  for (const ModeRun& run : input.modes) {
    size_t geometry = 0;
    while (geometry < jitters.size() && !share_geometry(input, *jitters[geometry], run.taa)) ++geometry;
    if (geometry == jitters.size()) jitters.push_back(&run.taa);
    geometry_of.push_back(geometry);
  }
  return jitters;
}

} // namespace

FrameSetup describe_frame(const FrameInput& given, const Scene& scene, const GpuScene& gpu,
                          FrameMemory& memory, LastFrame& before) {
  assert(!given.modes.empty());
  FrameInput input = given;
  if (input.cut) input.before = input.now; // nothing of before may be used
  const std::vector<glm::dmat4> now = pose(scene, input.now);
  const Objects objects = place_objects(input, scene, gpu, now);
  const std::vector<LightData> lights = place_lights(input, scene, now);
  FrameConstants constants{};
  describe_camera(constants, input, {0, 0});
  describe_light(constants, input);
  describe_underside(constants, input, gpu.vehicle);
  const std::vector<double> map_place = describe_shadow_map(constants, input);
  FrameContext in{.scene = gpu,
                  .modes = given.modes,
                  .view = input.settings.view,
                  .size = {input.width, input.height},
                  .index = input.index,
                  .cut = input.cut,
                  .constants = {},
                  .eye_from_object = {objects.eye_from_object.begin(), objects.eye_from_object.end()},
                  .previous_eye_from_object = memory.push_range(objects.previous_eye_from_object),
                  .lights = memory.push_range(lights),
                  .light_count = uint32_t(lights.size()),
                  .visible = {},
                  .casters = {},
                  .moved = objects.moved,
                  .mirrored = objects.mirrored,
                  .anything_moved = objects.anything_moved,
                  .shadow_texels = shadow_texels,
                  .shadow_version = version_of(before.shadows, map_place, objects, gpu, now),
                  .policy_changed = changes_of(before.policies, input.modes),
                  .tagged = tagged_range(input, gpu, objects),
                  .timed = input.timed};
  list_draws(in, constants, gpu, objects);

  FrameSetup setup;
  for (const TaaSettings* taa : share_geometries(input, setup.geometry_of)) {
    const glm::dvec2 own = jitter_offset(taa->policy.jitter, input.index) * double(taa->jitter_scale);
    const glm::dvec2 jitter_px = input.jitter_px.value_or(own);
    describe_camera(constants, input, jitter_px);
    const bool removed = taa->texture_jitter == TextureJitter::removed;
    constants.texture_jitter_px = removed ? jitter_px : glm::dvec2(0);
    constants.mip_bias = taa->mip_bias;
    in.shifts_textures = removed && jitter_px != glm::dvec2(0);
    in.biases_textures = taa->mip_bias != 0;
    in.constants = memory.push_value(constants);
    setup.contexts.push_back(in);
  }
  return setup;
}

} // namespace unghost
