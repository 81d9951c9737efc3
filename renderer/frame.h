// One frame: what the passes are told, and their order.
#pragma once

#include <deque>

#include "renderer/frame_input.h"
#include "renderer/passes/passes.h"

namespace unghost {

/// The images of a frame that somebody may ask for.
struct FrameImages {
  struct OfMode {
    ImageRef resolved, display;
    ImageRef probe;      // none where no pixel of it is probed
    size_t geometry = 0; // index into `geometries`
  };
  struct OfGeometry {
    GBuffer gbuffer;
    Motion motion;
    Lit lit;
  };
  std::vector<OfMode> modes;
  std::vector<OfGeometry> geometries; // one for each jitter among the modes
  ImageRef screen;                    // none where there is no window
};

/// Declares the frame. `contexts` has one entry for each jitter and outlives the graph; `geometry_of` says
/// which one each mode takes.
FrameImages declare_frame(FrameGraph& graph, const std::deque<FrameContext>& contexts,
                          const std::vector<size_t>& geometry_of);

/// What the window shows of the displays: whatever that is made from, and the picture.
ImageRef compose(FrameGraph& graph, const ScreenInput& screen, std::span<const ImageRef> displays);

/// Counts up when what the shadows of resting things are made from changes.
struct ShadowVersion {
  std::vector<double> made_from;
  uint64_t number = 0;
};

/// What the last frame's light was made from.
struct LastLight {
  LightSettings settings;
  std::vector<double> map_place; // of the shadow map: describe_shadow_map's
};

/// What the frame before leaves behind, its images aside.
struct LastFrame {
  std::vector<TaaPolicy> policies; // by place in the list of modes
  ShadowVersion shadows;
  uint32_t moved_ids = 0; // FrameContext's, of that frame alone
  LastLight light;
  float light_unit = 0;      // FrameConstants::light_unit
  VkRect2D moving_shadows{}; // texels of the shadow map that moving casters lay in
};

struct FrameSetup {
  std::deque<FrameContext> contexts;
  std::vector<size_t> geometry_of; // by mode
};
/// Poses the scene and describes it to the passes, once for each jitter among the modes.
FrameSetup describe_frame(FrameGraph& graph, const FrameInput& given, const Scene& scene, const GpuScene& gpu,
                          FrameMemory& memory, LastFrame& before);

} // namespace unghost
