// The panel beside the picture, and what is written above the picture: Dear ImGui widgets over a DemoState.
#pragma once

#include <deque>

#include "app/demo/demo_state.h"
#include "app/demo/measured_figures.h"

namespace unghost {

/// What the panel tells beside the state.
struct DemoFacts {
  std::string device;
  bool software = false;
  MeasuredFigures measured;
  std::vector<std::string> scenes;    // that have been shown, our own first
  std::optional<ProbedPixel> pixel;   // the picked one, as soon as it is known
  FrameResult frame;                  // the last one that is known: passes, images, what was left out
  std::deque<float> gpu_ms, frame_ms; // of the last frames: on the device, and from one to the next
  uint32_t picture_width = 0, picture_height = 0; // pixels drawn
  bool rests = false; // nothing moves, the history has settled, and no frame is drawn
};

constexpr size_t charted_frames = 120;

/// How wide it is, pixels, in a window of this width and height; `text_scale` as the Gui has it.
uint32_t panel_width(uint32_t width, double text_scale);
/// What a person who sees this for the first time presses.
constexpr std::string_view first_keys = "1: a ghost   0: hardly any   B: both\n"
                                        "V: magnify   H: all keys   U: hide all";
/// Changes `state` as a person asks.
void draw_panel(DemoState& state, const DemoFacts& facts, uint32_t width);

} // namespace unghost
