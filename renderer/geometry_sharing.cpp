#include "renderer/geometry_sharing.h"

#include "renderer/view.h"

namespace unghost {
namespace {

bool share_geometry(const FrameInput& input, const TaaSettings& a, const TaaSettings& b) {
  if (a.mip_bias != b.mip_bias) return false;
  if (input.jitter_px) return a.texture_jitter == b.texture_jitter;
  const double side = jitter_side(a, input);
  if (side != jitter_side(b, input)) return false;
  return side == 0 || (a.policy.jitter == b.policy.jitter && a.texture_jitter == b.texture_jitter);
}

} // namespace

SharedGeometries share_geometries(const FrameInput& input) {
  SharedGeometries shared;
  for (const ModeRun& run : input.modes) {
    size_t geometry = 0;
    while (geometry < shared.settings.size() && !share_geometry(input, *shared.settings[geometry], run.taa))
      ++geometry;
    if (geometry == shared.settings.size()) shared.settings.push_back(&run.taa);
    shared.of_mode.push_back(geometry);
  }
  return shared;
}

} // namespace unghost
