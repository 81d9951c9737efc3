// The frame's vocabulary on one page: every pass is a function from images to images. Only frame.cpp knows
// their order.
#pragma once

#include "renderer/gpu/graph_runner.h"
#include "renderer/passes/gpu_scene.h"
#include "renderer/probe.h"
#include "renderer/screen.h"
#include "renderer/settings.h"

namespace unghost {

/// Of what is tagged, along the view axis; zeros where nothing is.
struct DepthRange {
  float deepest_m = 0, length_m = 0;
};

/// What there is of the scene, even where more than that is drawn.
struct InView {
  bool anything = false, anything_moved = false; // to the camera
  bool moving_casters = false;                   // to the sun
};

/// What a pass is told of the frame. The same for all passes that share a jitter.
struct FrameContext {
  const GpuScene& scene;
  std::span<const ModeRun> modes;
  View view = View::colour;
  VkExtent2D size{};
  std::optional<ScreenInput> screen;
  std::optional<ProbeInput> probe;
  uint64_t index = 0;                       // of the frame
  bool cut = false;                         // nothing of the frame before may be used
  BufferSlice constants;                    // FrameConstants
  std::vector<glm::mat4x3> eye_from_object; // by object
  BufferSlice previous_eye_from_object;     // the same last frame, from that frame's eye
  BufferSlice lights;                       // LightData
  uint32_t light_count = 0;
  std::vector<const Draw*> visible; // to the camera: plain ones first, then by pipeline, near ones first
  size_t plain = 0;                 // so many of them neither move nor shine
  std::vector<const Draw*> casters; // that may throw a shadow into the shadow map's square
  std::vector<uint8_t> moved;       // by object: whether it is elsewhere than last frame
  std::vector<uint8_t> mirrored;    // by object: whether its triangles are turned inside out
  InView in_view;
  bool camera_moved = false;
  bool light_changes = false;    // on some surface, since the last frame
  bool mirrors_change = false;   // what glossy surfaces mirror: anything moves, in view or not, or light
  uint32_t moved_ids = 0;        // bit i: something of that id (shaders/shared/taa_key.h) moves, or did
  bool sun_shines = false;       // or somebody looks at its shadows
  uint32_t more_features = 0;    // beside each draw's own: bits of frame.h
  uint32_t shadow_texels = 0;    // along a side of the map
  uint64_t shadow_version = 0;   // changes with whatever the shadows of what rests depend on
  VkRect2D shadows_moved_before; // texels of the map that moving casters lay in, in the frame before
  std::vector<uint8_t> policy_changed; // by mode: its history is of another policy
  DepthRange tagged;
  bool timed = false;
};

/// What nobody reads of these is not drawn. Where a flag says that there is none, nobody reads what would say
/// more of it.
struct GBuffer {
  bool surfaces = false;                                           // anything but the sky
  bool lit = false, shines = false, moves = false, tagged = false; // some of them
  ImageRef albedo;        // RGBA8, square root of the albedo; a: ambient occlusion
  ImageRef normal;        // RG16 SNORM, octahedral, world axes
  ImageRef material;      // RGBA8: roughness (0: unlit), metalness, coat, coat roughness
  ImageRef emissive;      // B10G11R11, linear
  ImageRef depth;         // D32 S8: reversed depth; the tag
  ImageRef object_motion; // RGBA32F: motion in pixels, last frame's depth, 1 where given
  ImageRef object;        // R32UI: an OBJECT_ word of shaders/shared/taa_key.h
};

struct Motion {
  bool moves = false;      // some pixel
  ImageRef motion_px;      // RG32F
  ImageRef previous_depth; // R32F, metres
  ImageRef key;            // R32UI: shaders/shared/taa_key.h
  ImageRef depth; // R32F, to be loaded without a sampler: the G-buffer's depth, its last 8 bits the tag
};

struct Lit {
  ImageRef colour;     // RGBA16F, linear
  ImageRef visibility; // R8: how much of the sun is seen
  ImageRef irradiance; // R8UI: light that arrives, demodulated: light_word in shaders/shared/taa_key.h
};

struct Resolved {
  ImageRef colour; // RGBA16F, linear
  ImageRef why;    // RGBA32F: weight of the current frame, how far rectified, causes of rejection (TAA_REJECT
                   // bits) and class, age
  ImageRef history; // RGBA16F, linear: what was mixed with the current frame
  ImageRef probe;   // RGBA32F: the TAA_PROBE_ texels; none where no pixel of this mode is probed
};

struct TaaInputs {
  ImageRef colour;
  GBuffer gbuffer;
  Motion motion;
};

/// None where no sun is seen.
ImageRef draw_shadow_map(FrameGraph& graph, const FrameContext& in);
GBuffer draw_gbuffer(FrameGraph& graph, const FrameContext& in);
Motion resolve_motion(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer, const Lit& lit);
Lit light(FrameGraph& graph, const FrameContext& in, const GBuffer& gbuffer, ImageRef shadow_map);
/// The history is the run's own: it belongs to `place` in the list of modes.
Resolved resolve_taa(FrameGraph& graph, const FrameContext& in, const TaaInputs& inputs, size_t place);
/// Returns the colour where nothing is to be sharpened.
ImageRef sharpen(FrameGraph& graph, const FrameContext& in, ImageRef colour, size_t place);
/// A full-screen copy that nobody reads: what run times are compared with.
void copy_yardstick(FrameGraph& graph, const FrameContext& in, ImageRef colour);
/// sRGB, RGBA8.
ImageRef tonemap(FrameGraph& graph, const FrameContext& in, ImageRef colour);

struct ViewInputs {
  ImageRef picture;
  GBuffer gbuffer;
  Motion motion;
  Lit lit;
  Resolved resolved;
};
/// Draws the view that is set over the picture; returns the picture where that is the colour itself.
ImageRef draw_view(FrameGraph& graph, const FrameContext& in, const ViewInputs& inputs);
/// LDR-FLIP between two displays of one size, as somebody at the usual monitor sees it: R32F, 0 to 1.
ImageRef flip_error(FrameGraph& graph, ImageRef reference, ImageRef test);
/// What the window shows of the modes' displays, all of one size; RGBA8, of the window's size. Returns the
/// first display where the window shows just that. Displays that are not seen are not read. `error`: R32F, of
/// their size where the window shows it.
ImageRef compose_screen(FrameGraph& graph, const ScreenInput& screen, std::span<const ImageRef> displays,
                        ImageRef error);

} // namespace unghost
