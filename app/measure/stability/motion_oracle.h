// Motion in double precision on the CPU, from what a frame says of itself: the oracle of the motion pass.
#pragma once

#include "renderer/frame_input.h"

namespace unghost {

/// The most that motion is beside the truth, over all surfaces of a frame.
struct MotionDeviation {
  double motion_px = 0, depth = 0; // the latter relative, of the surface last frame
  size_t moving = 0, surfaces = 0; // pixels
};

/// `images`: motion, depth, object and previous depth as delivered; `jitter_px` is the frame's. What lay
/// further than 10,000 pixels away is not judged; what lay behind last frame's camera has to have come from
/// that far.
struct MotionImages {
  const FloatImage &motion, &depth, &object, &previous_depth;
};
MotionDeviation motion_deviation(const Scene& scene, const FrameInput& input, glm::dvec2 jitter_px,
                                 const MotionImages& images);

} // namespace unghost
