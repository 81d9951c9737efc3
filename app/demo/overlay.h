// What is written above the picture: the modes' names, what a key did, and the keys.
#pragma once

#include <span>

#include "app/demo/demo_state.h"

namespace unghost {

/// Where the picture lies in the window, pixels, and what it is composed of.
struct PicturePlace {
  glm::dvec2 at{0};
  ScreenInput screen;
};

struct Label {
  glm::dvec2 at{0}; // in the picture, pixels
  std::string words;
  bool to_the_left = false; // of `at`
};
/// The names of what is compared. `shown`: indices of the modes in the order of the frame's.
std::vector<Label> labels_of(const DemoState& state, const ScreenInput& screen,
                             std::span<const size_t> shown);
/// `shown`: indices of the modes in the order of the frame's.
void draw_labels(const DemoState& state, const PicturePlace& place, std::span<const size_t> shown);
/// Around the picked pixel, wherever one of the pictures shows it. `picture_px`: the size that they were
/// drawn at.
void draw_marker(const DemoState& state, const PicturePlace& place, size_t modes, glm::ivec2 picture_px);
void draw_message(const std::string& message, const PicturePlace& place);
/// That a recording or a replay goes on, and how far.
void draw_path_notice(const DemoState& state, const PicturePlace& place);
/// Every key with what it does and its present state; greyed, with why, where it has no effect.
void draw_keys(const DemoState& state, const PicturePlace& place);

} // namespace unghost
