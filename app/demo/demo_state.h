// What the demo shows, and how, as plain data: keys, gamepad, panel and the file that keeps it from run to
// run all change this and nothing else.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/demo/camera.h"
#include "app/paths.h"
#include "renderer/screen.h"

namespace unghost {

/// The row without a history, which switches TAA off.
constexpr std::string_view no_taa = "off";

/// A pixel that a person asks about.
struct Picked {
  size_t mode = 0;  // by place among the frame's modes
  glm::dvec2 at{0}; // shares of the picture's size

  bool operator==(const Picked&) const = default;
};

/// What one frame does that the next one does not.
struct DemoRequests {
  bool step = false;         // one frame more while paused
  bool drop_history = false; // nothing of before may be used
  bool screenshot = false;
  bool copy_command = false;        // to the clipboard
  bool full_screen = false;         // changes it
  bool record = false;              // begins a recording, or ends it
  bool replay = false;              // begins a replay, or ends it
  std::optional<std::string> scene; // is loaded
  bool leave = false;

  bool operator==(const DemoRequests&) const = default;
};

/// A view to come back to: the same picture, and the same place about the vehicle at another time.
struct Bookmark {
  std::string rig = "drive";
  uint64_t rig_frame = 0; // its time
  CameraOffset camera;

  bool operator==(const Bookmark&) const = default;
};
constexpr size_t most_bookmarks = 100;

/// Beside the mode that is shown.
constexpr size_t most_compared = 3;

struct DemoState {
  std::string scene = own_scene, rig = "drive";
  uint64_t seed = 1;
  Settings settings;            // what all modes share; its taa is not read
  std::vector<ModeRun> modes;   // every row of the table, as it has been changed
  size_t mode = 0;              // of `modes`: what is shown, or the first of what is compared
  std::vector<size_t> compared; // of `modes`: what stands beside it, from one to most_compared
  size_t shown_before = 0;      // of `modes`: what TAA is switched on to again
  Arrangement arrangement = Arrangement::single;
  double split = 0.5;   // where the bar stands, a share of the width
  bool flicker = false; // while a key is held: the compared mode in place of the shown one
  Magnifier magnifier;
  bool magnifier_follows = false; // the mouse
  std::optional<Picked> picked;
  uint64_t rig_frame = 0;       // the rig's time, of the next frame
  uint64_t rig_frame_shown = 0; // and of the one that was drawn last
  CameraOffset camera;
  std::vector<Bookmark> bookmarks;
  std::optional<size_t> bookmark;             // of `bookmarks`: the one that was kept or gone to last
  bool moving = true;                         // the rig's time goes on
  bool paused = false;                        // no frame is drawn
  bool panel = true, keys = false;            // shown
  bool hidden = false;                        // nothing but the picture
  double render_scale = 1;                    // pixels rendered a pixel shown, along each axis; 0.5 to 1
  std::optional<double> frame_ms;             // the scale is chosen so that a frame takes so long
  std::optional<uint64_t> recorded, replayed; // frames so far, while a recording or a replay goes on
  std::string path_file;                      // what there is to replay
  DemoRequests requests;
  std::string message; // what the last key did; shown for a second

  bool operator==(const DemoState&) const = default;
};

/// The pixel that lies there in a picture of that size.
glm::ivec2 pixel_of(const Picked& picked, glm::ivec2 picture_px);
/// Every mode as its row has it, and what the command line's defaults are.
DemoState default_demo_state();
/// What the mode at that place of `modes` is drawn with.
Settings settings_of(const DemoState& state, size_t mode);
/// The places in `modes` of what is seen, the shown one first.
std::vector<size_t> modes_seen(const DemoState& state);
/// Shows that mode. One that was compared changes places with what was shown: none is seen twice.
void show_mode(DemoState& state, size_t mode);
/// Sets that mode at that place of `compared`. One that is seen already changes places with what was there.
void compare_with(DemoState& state, size_t place, size_t mode);
/// Sets the first of `modes` that is not seen yet beside the others, which takes a grid where two are shown
/// by a bar.
void compare_one_more(DemoState& state);
/// The least is one beside the shown one.
void compare_one_less(DemoState& state);
/// Whether the shown mode has a setting that its row of the table has not.
bool is_changed(const DemoState& state);
/// The shown mode as its row of the table has it.
void reset_mode(DemoState& state);
/// Everything as in the first run, but for the scene, its time, bookmarks and recordings.
void reset_all(DemoState& state);
/// Keeps the view that is shown, after the others; there are fewer than most_bookmarks.
void keep_bookmark(DemoState& state);
/// The same view: rig, its time and camera. Nothing of before may be used.
void go_to_bookmark(DemoState& state, size_t place);
/// Its camera alone, wherever the vehicle is by now.
void look_as_bookmark(DemoState& state, size_t place);
void forget_bookmark(DemoState& state, size_t place);
/// The place of the mode of that name. Throws SettingError with the nearest name.
size_t place_of_mode(const DemoState& state, std::string_view name);

} // namespace unghost
