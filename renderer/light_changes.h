// Where light may be another than in the last frame: what rests in light that stays has a history that no
// light makes wrong.
#pragma once

#include <vector>

#include "renderer/frame.h"

namespace unghost {

struct LightNow {
  VkRect2D swept_shadows{};      // texels of the shadow map that moving casters lie in, or did
  std::vector<double> map_place; // of the shadow map: describe_shadow_map's
  bool lamps_moved = false;
  bool objects_moved = false; // in view: they come to other light
};

/// Fills the part of FrameConstants that says so, of which describe_underside's is there, and returns whether
/// it is so anywhere; `before` becomes this frame's.
bool describe_light_changes(FrameConstants& constants, const FrameInput& input, const LightNow& now,
                            LastLight& before);

} // namespace unghost
