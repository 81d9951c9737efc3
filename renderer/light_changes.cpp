#include "renderer/light_changes.h"

#include "renderer/sun.h"

namespace unghost {
namespace {

struct Texels {
  glm::vec2 low, high;
};

Texels texels_of(const VkRect2D& rect) {
  const glm::vec2 low(rect.offset.x, rect.offset.y);
  return {low, low + glm::vec2(rect.extent.width, rect.extent.height)};
}

} // namespace

void describe_light_changes(FrameConstants& constants, const FrameInput& input, const LightNow& now,
                            LastLight& before) {
  const bool all = now.lamps_moved || input.now.towards_sun != input.before.towards_sun ||
                   input.settings.light != before.settings;
  const bool underside = input.now.vehicle != input.before.vehicle;
  constants.light_changes = (all ? LIGHT_CHANGES_ALL : 0u) | (underside ? LIGHT_CHANGES_UNDERSIDE : 0u);

  // The filter of light.comp reaches two texels beyond. Where the map itself was elsewhere, so were its
  // texels: things move by less than this in a frame.
  constexpr float filtered = 2, moved = 64;
  Texels at = texels_of(now.moving_shadows);
  const Texels at_before = texels_of(before.moving_shadows);
  const float reach = now.map_place == before.map_place ? filtered : moved;
  const auto any = [](const VkRect2D& rect) { return rect.extent.width > 0; };
  if (reach == filtered && any(before.moving_shadows) && any(now.moving_shadows))
    at = {glm::min(at.low, at_before.low), glm::max(at.high, at_before.high)};
  else if (reach == filtered && any(before.moving_shadows))
    at = at_before;
  const bool none = at.low == at.high; // nowhere
  constants.shadows_move_from = none ? glm::vec2(2) : (at.low - reach) / float(shadow_texels);
  constants.shadows_move_to = none ? glm::vec2(2) : (at.high + reach) / float(shadow_texels);
  before = {
      .settings = input.settings.light, .map_place = now.map_place, .moving_shadows = now.moving_shadows};
}

} // namespace unghost
