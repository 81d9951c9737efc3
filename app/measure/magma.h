// Errors in colours: dark where there are none, bright where they are large.
#pragma once

#include "renderer/frame_input.h"

namespace unghost {

/// Matplotlib's magma (van der Walt and Smith, CC0) for values from 0 to 1.
Image magma(const FloatImage& values);

} // namespace unghost
