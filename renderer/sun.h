// The sun, the sky, and the square of ground that the shadow map covers.
#pragma once

#include "renderer/frame_input.h"
#include "shaders/shared/frame.h"

namespace unghost {

/// Side of the shadow map in texels.
inline constexpr uint32_t shadow_texels = 2048;

/// The sun and sky part of FrameConstants. Returns a number that changes with the map's place: shadows of
/// what rests stay valid while it stays.
uint64_t describe_sun(FrameConstants& constants, const FrameInput& input);

} // namespace unghost
