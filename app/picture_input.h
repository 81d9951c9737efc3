// Pictures that measurements compare: PNG, OpenEXR and Radiance HDR, as linear RGB.
#pragma once

#include <filesystem>

#include "renderer/frame_input.h"

namespace unghost {

struct LinearPicture {
  FloatImage image; // three channels; alpha is left out
  bool hdr = false; // of a format without bounds
};

/// The format is told by the first bytes. Throws Failure(input_refused).
LinearPicture read_picture(const std::filesystem::path& path);

} // namespace unghost
