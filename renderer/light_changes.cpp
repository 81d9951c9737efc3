#include "renderer/light_changes.h"

#include "renderer/sun.h"
#include "shaders/shared/shadow.h"

namespace unghost {

bool describe_light_changes(FrameConstants& constants, const FrameInput& input, const LightNow& now,
                            LastLight& before) {
  const bool sun = input.settings.light.sun_illuminance > 0;
  const bool all = now.lamps_moved || input.now.towards_sun != input.before.towards_sun ||
                   input.settings.light != before.settings ||
                   (sun && now.map_place != before.map_place); // shadows end where the map does
  const bool underside = constants.underside_half.x > 0 && input.now.vehicle != input.before.vehicle;
  constants.light_changes = (all ? LIGHT_CHANGES_ALL : 0u) | (underside ? LIGHT_CHANGES_UNDERSIDE : 0u);

  const glm::vec2 low(now.swept_shadows.offset.x, now.swept_shadows.offset.y),
      size(now.swept_shadows.extent.width, now.swept_shadows.extent.height);
  const bool shadows = sun && size.x > 0 && size.y > 0;
  constants.shadows_move_from =
      shadows ? (low - SHADOW_REACH_TEXELS) / float(shadow_texels) : glm::vec2(2); // nowhere
  constants.shadows_move_to =
      shadows ? (low + size + SHADOW_REACH_TEXELS) / float(shadow_texels) : glm::vec2(2);
  before = {.settings = input.settings.light, .map_place = now.map_place};
  return all || underside || shadows || now.objects_moved;
}

} // namespace unghost
