// What the screen would show of linear colours, in floats.
#pragma once

#include "renderer/frame_input.h"

namespace unghost {

/// Exposed by `exposure_ev`, tone-mapped and sRGB-encoded, 0 to 1; rgb in, rgb out.
FloatImage displayed(const FloatImage& linear, float exposure_ev);
/// The same in 8 bits, rounded as the device rounds; opaque.
Image displayed_8_bit(const FloatImage& linear, float exposure_ev);

} // namespace unghost
