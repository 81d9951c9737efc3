// One pixel of a frame, and what its resolve made it from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

#include "renderer/settings.h"

namespace unghost {

/// Which pixel: `mode` is an index into the frame's modes, x and y lie in the picture.
struct ProbeInput {
  size_t mode = 0;
  uint32_t x = 0, y = 0;

  bool operator==(const ProbeInput&) const = default;
};

/// What the resolve itself says of a pixel that had a history.
struct ProbedHistory {
  glm::vec3 found{0};    // linear, as it was read, and lit anew where light changed
  glm::vec3 bounded{0};  // after rectification, in the mode's colour space and weighting
  float moved = 0;       // by the rectification: 1 by a tenth of itself or more
  bool rectified = true; // or left alone, where only the unknown is bounded
  size_t speaker = 4;    // which of the 3x3 pixels' motion was followed, row by row
  glm::dvec2 at_px{0};   // where it was read; pixel centres are at .5
};

/// As the outputs of the same names are. What the mode's resolve does not know is as if there were no
/// history.
struct ProbedPixel {
  ProbeInput input;
  ModeRun mode;
  float exposure = 1;                 // what colours are multiplied by before the tone map
  std::array<glm::vec3, 9> colours{}; // `lit` of the pixel and its neighbours, row by row; the edge goes on
  glm::vec3 mixed_in{0};              // of the new frame: the pixel itself, or interpolated at its middle
  glm::vec3 resolved{0};
  float depth_m = 0;
  glm::vec2 motion_px{0};
  uint8_t tag = 0;
  uint32_t object = 0;
  float weight = 1;                     // of the new frame
  float count = 1;                      // frames that the result holds, where the mode counts them
  Reject causes = Reject::nothing;      // of a rejection of the history, in whole or in part
  std::optional<ProbedHistory> history; // none: the new frame was taken as it is

  /// The mode's, without what did not bound this pixel's history.
  TaaSettings taa() const {
    TaaSettings settings = mode.taa;
    if (history && !history->rectified) settings.policy.rectify = Rectify::none;
    return settings;
  }
};

} // namespace unghost
