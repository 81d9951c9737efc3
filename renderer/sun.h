// The sun, the sky, and the square of ground that the shadow map covers.
#pragma once

#include <vector>

#include "renderer/frame_input.h"
#include "shaders/shared/frame.h"

namespace unghost {

/// Side of the shadow map in texels.
inline constexpr uint32_t shadow_texels = 2048;

/// The sun and sky part of FrameConstants.
void describe_light(FrameConstants& constants, const FrameInput& input);
/// The shadow map's part of FrameConstants. Returns where the map lies and where the sun stands: shadows of
/// what rests stay valid while that stays.
std::vector<double> describe_shadow_map(FrameConstants& constants, const FrameInput& input);

} // namespace unghost
