// What a frame is made from: two instants of a rig, the modes to resolve, and what is wanted of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "renderer/gpu/frame_report.h"
#include "renderer/probe.h"
#include "renderer/scene/scene.h"
#include "renderer/screen.h"
#include "renderer/settings.h"

namespace unghost {

/// Where everything is at one moment: what a rig computes as a pure function of time. World space, metres,
/// double.
struct Instant {
  glm::dvec3 eye{0, 1.6, 6};
  glm::dquat camera{1, 0, 0, 0}; // turns -z to where the camera looks
  double vertical_fov = 0.8;     // radians
  double near_plane = 0.1;       // metres
  glm::dmat4 vehicle{1};         // the vehicle's frame: origin on the ground, +z forward
  double wheel_travel = 0;       // metres rolled; a wheel's angle is this over its radius
  double steer = 0;              // radians, to the left
  double animation_s = 0;        // the clock of the scene's own animations
  glm::dvec3 towards_sun{0, 1, 0};

  bool operator==(const Instant&) const = default;
};

/// One that can be asked of a frame; those above `lit` once a mode, the rest once a jitter sequence (`mode`
/// then says whose).
enum class Output {
  display,        // what the screen shows: RGBA, sRGB, 8 bits
  resolved,       // linear HDR after resolve and sharpening, rgb
  lit,            // linear HDR before the resolve, rgb
  depth,          // metres along the view axis, +inf for the sky
  motion,         // pixels, previous minus current, without jitter, xy
  previous_depth, // metres along last frame's view axis of the same surface point
  tag,            // 0 to 255
  object,         // node index + 1, 0 for the sky
  sun_visibility, // 0 in shadow to 1
  screen,         // once a frame, where there is one: what the window shows, as `display` but of its size
};

struct Wanted {
  Output what = Output::display;
  size_t mode = 0; // index into FrameInput::modes
};

struct FrameInput {
  Instant now, before;                 // the same where nothing moved
  uint64_t index = 0;                  // chooses the jitter
  std::optional<glm::dvec2> jitter_px; // instead of every mode's own: a sample of a supersampled frame
  bool cut = false;                    // nothing of before may be used
  bool keeps_nothing = false;          // but its histories: what rests is drawn again, too
  uint32_t width = 1280, height = 720;
  Settings settings; // light, stage and view; each run brings its own taa
  std::vector<ModeRun> modes;
  std::optional<ScreenInput> screen; // out of the first modes' displays
  bool shown = false;                // the screen, or else the first mode's display, is made, wanted or not
  std::string left_out; // where settings keep everything: all but this, by its name in FrameResult
  bool timed = false;   // resolves every mode, wanted or not, and draws a full-screen copy to compare with
  std::vector<Wanted> wanted;
  std::optional<ProbeInput> probe;
};

/// Values of an image, row by row from the top.
struct FloatImage {
  uint32_t width = 0, height = 0, channels = 0;
  std::vector<float> values;
};

/// What came of one Wanted: `picture` for the display and the screen, `image` for all else.
struct Delivered {
  Image picture;
  FloatImage image;
};

struct FrameResult {
  std::vector<Delivered> delivered; // as many as were wanted, in their order
  std::optional<ProbedPixel> probe; // where there was one
  std::vector<PassReport> passes;
  std::vector<UsedImage> images; // all that the frame touches, each once
  std::vector<LeftOut> left_out;
  uint64_t image_bytes = 0; // of all images
};

} // namespace unghost
