#include "renderer/draw_lists.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "renderer/scene/bounds.h"
#include "renderer/sun.h"

namespace unghost {
namespace {

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

bool casts_shadow(const Draw& draw) { return (draw.features & IS_UNLIT) == 0 && !draw.blended; }

/// The texels of the shadow map that what lies in `box`, in clip space, may fall in.
VkRect2D texels_of(const Bounds& box) {
  if (box.empty()) return {};
  constexpr glm::dvec2 rounding(2), least(0), most(shadow_texels);
  const auto texel_of = [&](glm::dvec3 clip) { return (glm::dvec2(clip) * 0.5 + 0.5) * most; };
  const glm::dvec2 low = glm::clamp(glm::floor(texel_of(box.low)) - rounding, least, most);
  const glm::dvec2 high = glm::clamp(glm::ceil(texel_of(box.high)) + rounding, least, most);
  return {{int32_t(low.x), int32_t(low.y)}, {uint32_t(high.x - low.x), uint32_t(high.y - low.y)}};
}

/// `seen_by_sun`: by draw, whether it may throw a shadow into the map.
MovingShadows moving_shadows(const GpuScene& gpu, const PlacedObjects& objects,
                             const glm::dmat4& shadow_clip_from_eye,
                             const std::vector<uint8_t>& seen_by_sun) {
  Bounds now, swept; // in the map
  for (size_t i = 0; i < gpu.draws.size(); ++i) {
    const Draw& draw = gpu.draws[i];
    if (objects.moved[draw.object] == 0 || !casts_shadow(draw)) continue;
    const glm::dmat4 before = objects.eye_from_object_before(draw.object);
    for (const glm::dvec4& corner : corners_of(draw.bounds)) {
      const glm::dvec3 at(shadow_clip_from_eye * objects.eye_from_object[draw.object] * corner);
      swept.add(at);
      swept.add(glm::dvec3(shadow_clip_from_eye * before * corner));
      if (seen_by_sun[i] != 0) now.add(at);
    }
  }
  return {.now = texels_of(now), .swept = texels_of(swept)};
}

/// Of draws and their distances.
void put_in_order(FrameContext& in, std::vector<std::pair<double, const Draw*>> draws,
                  const PlacedObjects& objects) {
  const auto is_plain = [&](const Draw& draw) { return !draw.shines && objects.moved[draw.object] == 0; };
  // What writes fewer images must not hide in the others what was written there before. Then pipelines change
  // seldom, and within one near things come first, so that what lies behind them is not shaded.
  std::ranges::stable_sort(draws, {}, [&](const auto& one) {
    return std::tuple(!is_plain(*one.second), one.second->features, one.first);
  });
  for (const auto& [distance, draw] : draws) {
    in.visible.push_back(draw);
    in.plain += is_plain(*draw);
  }
}

} // namespace

MovingShadows list_draws(FrameGraph& graph, FrameContext& in, const FrameConstants& constants,
                         const GpuScene& gpu, const PlacedObjects& objects) {
  const glm::dmat4 clip_from_eye(constants.clip_from_eye);
  glm::dmat4 shadow_clip_from_eye(constants.shadow_from_eye);
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 2; ++row)
      shadow_clip_from_eye[column][row] = 2 * shadow_clip_from_eye[column][row] - (column == 3 ? 1 : 0);
  // Culling does not see the jitter: it could move things by half a pixel.
  const glm::dvec2 side = 1.0 + 1.0 / glm::dvec2(constants.size_px);
  std::vector<uint8_t> seen, seen_by_sun;
  for (const Draw& draw : gpu.draws) {
    const glm::dmat4& eye_from_object = objects.eye_from_object[draw.object];
    const bool moved = objects.moved[draw.object] != 0;
    seen.push_back(may_be_seen(draw.bounds, clip_from_eye * eye_from_object, side));
    seen_by_sun.push_back(!casts_shadow(draw) ||
                          may_be_seen(draw.bounds, shadow_clip_from_eye * eye_from_object));
    in.in_view.anything |= seen.back() != 0;
    in.in_view.anything_moved |= moved && seen.back() != 0;
    in.in_view.moving_casters |= moved && casts_shadow(draw) && seen_by_sun.back() != 0;
  }
  const auto needed = [&](const std::vector<uint8_t>& within, const char* what, const char* where) {
    const auto beyond = std::ranges::count(within, 0);
    return graph.needed(beyond == 0,
                        {what, std::to_string(beyond) + " lie beyond the sides of the " + where});
  };
  const bool all_seen = needed(seen, "draws out of view", "picture");
  const bool all_cast = needed(seen_by_sun, "casters out of the map", "shadow map");
  std::vector<std::pair<double, const Draw*>> by_distance;
  for (size_t i = 0; i < gpu.draws.size(); ++i) {
    const Draw& draw = gpu.draws[i];
    if (all_seen || seen[i] != 0)
      by_distance.emplace_back(distance_to(draw.bounds, objects.eye_from_object[draw.object]), &draw);
    if (casts_shadow(draw) && (all_cast || seen_by_sun[i] != 0)) in.casters.push_back(&draw);
  }
  put_in_order(in, std::move(by_distance), objects);
  return moving_shadows(gpu, objects, shadow_clip_from_eye, seen_by_sun);
}

} // namespace unghost
