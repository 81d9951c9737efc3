// Which modes of a frame see the same samples of the scene, so that geometry and light are drawn once for
// them.
#pragma once

#include <cstddef>
#include <vector>

#include "renderer/frame_input.h"

namespace unghost {

struct SharedGeometries {
  std::vector<size_t> of_mode;              // by mode, the index of its geometry
  std::vector<const TaaSettings*> settings; // by geometry, where its jitter comes from: in the input's modes
};
SharedGeometries share_geometries(const FrameInput& input);

} // namespace unghost
