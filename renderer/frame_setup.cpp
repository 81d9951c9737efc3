#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/draw_lists.h"
#include "renderer/frame.h"
#include "renderer/geometry_sharing.h"
#include "renderer/light_changes.h"
#include "renderer/pose.h"
#include "renderer/scene/bounds.h"
#include "renderer/sun.h"
#include "renderer/view.h"
#include "shaders/shared/taa_key.h"

namespace unghost {
namespace {

glm::dmat4 relative_to(glm::dvec3 eye, glm::dmat4 world) {
  world[3] -= glm::dvec4(eye, 0);
  return world;
}

PlacedObjects place_objects(const FrameInput& input, const Scene& scene, const GpuScene& gpu,
                            const std::vector<glm::dmat4>& now) {
  const std::vector<glm::dmat4> before = pose(scene, input.before);
  PlacedObjects objects;
  for (const int node : gpu.object_nodes) {
    const glm::dmat4 eye_from_object = relative_to(input.now.eye, now[size_t(node)]);
    const bool moved = now[size_t(node)] != before[size_t(node)];
    objects.eye_from_object.push_back(eye_from_object);
    objects.moved.push_back(moved);
    objects.previous_eye_from_object.emplace_back(relative_to(input.before.eye, before[size_t(node)]));
    objects.mirrored.push_back(glm::determinant(glm::dmat3(eye_from_object)) < 0);
  }
  objects.eye_moved = input.now.eye - input.before.eye;
  for (size_t n = 0; n < scene.nodes.size(); ++n)
    objects.lamps_moved |= scene.nodes[n].light >= 0 && now[n] != before[n];
  return objects;
}

/// The body's underside hides the sky from the road; wheels reach below it, bumpers and mirrors beyond.
void describe_underside(FrameConstants& constants, const FrameInput& input, const Bounds& vehicle) {
  constants.underside_half = glm::vec2(0);
  if (vehicle.empty()) return;
  const glm::dvec3 low(vehicle.low), high(vehicle.high), size = high - low, middle = (low + high) / 2.0;
  constexpr double clearance = 0.16, body = 0.9; // of its height; of its length and width
  const glm::dmat4 vehicle_from_underside =
      glm::translate(glm::dmat4(1), glm::dvec3(middle.x, low.y + clearance * size.y, middle.z));
  const auto eye_from_underside = [&](const glm::dmat4& vehicle_pose) {
    return relative_to(input.now.eye, vehicle_pose) * vehicle_from_underside;
  };
  const glm::dmat4 underside_from_eye = glm::inverse(eye_from_underside(input.now.vehicle)),
                   now_from_before = underside_from_eye * eye_from_underside(input.before.vehicle);
  const glm::dvec2 half = glm::dvec2(size.x, size.z) / 2.0 * body;
  glm::dvec2 swept_low = -half, swept_high = half;
  for (const glm::dvec2 side : {glm::dvec2(-1, -1), {1, -1}, {-1, 1}, {1, 1}}) {
    const glm::dvec4 corner = now_from_before * glm::dvec4(side.x * half.x, 0, side.y * half.y, 1);
    swept_low = glm::min(swept_low, glm::dvec2(corner.x, corner.z));
    swept_high = glm::max(swept_high, glm::dvec2(corner.x, corner.z));
  }
  constants.underside_from_eye = glm::dmat4x3(underside_from_eye);
  constants.underside_half = half;
  constants.underside_swept_low = swept_low;
  constants.underside_swept_high = swept_high;
}

/// What every pipeline is made with beside what its own draws ask for: a white texture multiplies by 1, and
/// what has no mask passes every test. A transform of texture coordinates that changes nothing rounds, and is
/// not among them.
uint32_t features_of_all(FrameGraph& graph, const SceneTraits& traits) {
  constexpr uint32_t textures =
      ((1u << MATERIAL_TEXTURES) - 1) & ~(1u << TEXTURE_NORMAL); // a white normal is none
  const auto all_have = [&](uint32_t features) { return (traits.features & features) == features; };
  uint32_t features = 0;
  if (graph.needed(all_have(HAS_ALPHA_MASK),
                   {"alpha test", traits.masked ? "not every material is masked" : "no material is masked"}))
    features |= HAS_ALPHA_MASK;
  if (graph.needed(all_have(textures), {"textures", "a material samples only those that it has"}))
    features |= textures;
  return features;
}

/// Bits of this frame's jitter.
uint32_t features_of_jitter(FrameGraph& graph, const TaaSettings& taa, glm::dvec2 shift_px) {
  uint32_t features = 0;
  if (graph.needed(shift_px != glm::dvec2(0),
                   {"texture shift", "there is no jitter that textures could be kept from"}))
    features |= SHIFTS_TEXTURES;
  if (graph.needed(taa.mip_bias != 0, {"mip bias", "mip-bias is 0"})) features |= BIASES_TEXTURES;
  return features;
}

/// Somewhere, so that it has a direction.
constexpr LightData dark_lamp{
    .position_eye = {3, 5, 4}, .direction_eye = {0.36f, -0.8f, 0.48f}, .spot_offset = 1, .directional = 1};

std::vector<LightData> place_lights(FrameGraph& graph, const FrameInput& input, const Scene& scene,
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
  if (graph.needed(!lights.empty(), {"lamps", "the scene has none"}) && lights.empty())
    lights.push_back(dark_lamp);
  return lights;
}

/// Changes when the map moves, the sun does, or what rests is elsewhere or no longer rests. A map that is
/// kept was rounded where the eye was then: a cut, which shows nothing of before, draws it again.
uint64_t version_of(ShadowVersion& version, std::vector<double> place, const PlacedObjects& objects,
                    const GpuScene& gpu, const std::vector<glm::dmat4>& now, bool draw_again) {
  for (size_t i = 0; i < objects.moved.size(); ++i) {
    place.push_back(objects.moved[i]);
    if (objects.moved[i]) continue;
    const glm::dmat4& world = now[size_t(gpu.object_nodes[i])];
    place.insert(place.end(), &world[0].x, &world[0].x + 16);
  }
  if (draw_again || place != version.made_from) {
    version.made_from = std::move(place);
    ++version.number;
  }
  return version.number;
}

/// How deep what is tagged lies before the camera, and how far it reaches from one end to the other; zeros
/// where nothing is.
DepthRange tagged_range(const FrameInput& input, const GpuScene& gpu, const PlacedObjects& objects) {
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

/// Its light, or its shadows.
bool shows_sun(const FrameInput& input) {
  return input.settings.light.sun_illuminance > 0 || input.settings.view == View::shadow ||
         std::ranges::find(input.wanted, Output::sun_visibility, &Wanted::what) != input.wanted.end();
}

/// Of this frame and the one before, which becomes this one.
uint32_t moved_ids(const GpuScene& gpu, const PlacedObjects& objects, uint32_t& before) {
  uint32_t now = 0;
  for (size_t i = 0; i < objects.moved.size(); ++i)
    if (objects.moved[i] != 0) now |= 1u << (gpu.object_words[i] >> OBJECT_ID_SHIFT);
  return now | std::exchange(before, now);
}

/// By mode, whether its history is of another policy, or holds light in another unit than `light_unit`;
/// `before` becomes this frame's.
std::vector<uint8_t> changes_of(LastFrame& before, const std::vector<ModeRun>& modes, float light_unit) {
  const bool other_unit = std::exchange(before.light_unit, light_unit) != light_unit;
  std::vector<uint8_t> changed;
  for (size_t i = 0; i < modes.size(); ++i) {
    const TaaPolicy& policy = modes[i].taa.policy;
    const bool same = i < before.policies.size() && before.policies[i] == policy;
    changed.push_back(!same || (other_unit && policy.rejects(Reject::visibility)));
  }
  before.policies.clear();
  for (const ModeRun& run : modes) before.policies.push_back(run.taa.policy);
  return changed;
}

/// Of light, and of what mirrors it.
void describe_changes(FrameContext& in, FrameConstants& constants, const FrameInput& input,
                      const LightNow& light, LastLight& before) {
  in.light_changes = describe_light_changes(constants, input, light, before);
  in.mirrors_change = in.camera_moved || in.moved_ids != 0 || in.light_changes;
  constants.mirrors_change = in.mirrors_change;
}

/// The frame once for each jitter. `given` says how all moves, of which a cut is nothing; `input` what is
/// there of the frame before.
FrameSetup by_jitter(FrameGraph& graph, const FrameInput& given, const FrameInput& input,
                     const FrameContext& in, FrameConstants constants, FrameMemory& memory) {
  const SharedGeometries shared = share_geometries(given);
  FrameSetup setup{.contexts = {}, .geometry_of = shared.of_mode};
  for (const TaaSettings* taa : shared.settings) {
    const glm::dvec2 jitter_px = jitter_of(*taa, given);
    describe_camera(constants, input, jitter_px);
    const bool removed = taa->texture_jitter == TextureJitter::removed;
    const glm::dvec2 shift_px = removed ? jitter_px : glm::dvec2(0);
    constants.texture_jitter_px = shift_px;
    constants.mip_bias = taa->mip_bias;
    FrameContext& context = setup.contexts.emplace_back(in);
    context.constants = memory.push_value(constants);
    context.more_features |= features_of_jitter(graph, *taa, shift_px);
  }
  return setup;
}

} // namespace

FrameSetup describe_frame(FrameGraph& graph, const FrameInput& given, const Scene& scene, const GpuScene& gpu,
                          FrameMemory& memory, LastFrame& before) {
  assert(!given.modes.empty());
  FrameInput input = given;
  if (input.cut) input.before = input.now; // nothing of before may be used
  const std::vector<glm::dmat4> now = pose(scene, input.now);
  const PlacedObjects objects = place_objects(input, scene, gpu, now);
  const std::vector<LightData> lights = place_lights(graph, input, scene, now);
  FrameConstants constants{};
  describe_camera(constants, input, {0, 0});
  describe_light(constants, input);
  describe_underside(constants, input, gpu.vehicle);
  const std::vector<double> map_place = describe_shadow_map(constants, input);
  FrameContext in{.scene = gpu,
                  .modes = given.modes,
                  .view = input.settings.view,
                  .size = {input.width, input.height},
                  .screen = input.screen,
                  .probe = input.probe,
                  .index = input.index,
                  .cut = input.cut,
                  .constants = {},
                  .eye_from_object = {objects.eye_from_object.begin(), objects.eye_from_object.end()},
                  .previous_eye_from_object = memory.push_range(objects.previous_eye_from_object),
                  .lights = memory.push_range(lights),
                  .light_count = uint32_t(lights.size()),
                  .visible = {},
                  .plain = 0,
                  .casters = {},
                  .moved = objects.moved,
                  .mirrored = objects.mirrored,
                  .in_view = {},
                  .camera_moved = camera_moves(input),
                  .moved_ids = moved_ids(gpu, objects, before.moved_ids),
                  .sun_shines = shows_sun(input),
                  .more_features = features_of_all(graph, gpu.traits),
                  .shadow_texels = shadow_texels,
                  .shadow_version = version_of(before.shadows, map_place, objects, gpu, now,
                                               input.keeps_nothing || input.cut),
                  .shadows_moved_before = {},
                  .policy_changed = changes_of(before, input.modes, constants.light_unit),
                  .tagged = tagged_range(input, gpu, objects),
                  .timed = input.timed};
  const MovingShadows shadows = list_draws(graph, in, constants, gpu, objects);
  in.shadows_moved_before = std::exchange(before.moving_shadows, shadows.now);
  describe_changes(in, constants, input,
                   {.swept_shadows = shadows.swept,
                    .map_place = map_place,
                    .lamps_moved = objects.lamps_moved,
                    .objects_moved = in.in_view.anything_moved},
                   before.light);
  return by_jitter(graph, given, input, in, constants, memory);
}

} // namespace unghost
