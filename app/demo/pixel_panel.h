// What became of one pixel, and why: for the panel.
#pragma once

#include <optional>

#include "renderer/probe.h"

namespace unghost {

/// How to ask for one, where there is none.
void draw_pixel(const std::optional<ProbedPixel>& pixel);

} // namespace unghost
