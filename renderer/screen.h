// How a window, or a picture of what it shows, sets the modes of a frame beside one another: what is asked
// for, and where everything then lies. Pictures are shown in the window's aspect.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "shaders/shared/screen.h"

namespace unghost {

#define UNGHOST_ENUMERATOR(column, answer, value) answer = value,
/// Where it takes two modes and there is one, that one alone is shown.
enum class Arrangement : uint32_t { UNGHOST_ARRANGEMENTS(UNGHOST_ENUMERATOR) };
#undef UNGHOST_ENUMERATOR

/// A region of the picture, enlarged as its pixels are: as the GDK sample has it, a twentieth of the
/// picture's width, seven times as large.
struct Magnifier {
  bool shown = false;
  glm::dvec2 centre{0.5}; // of the picture, as shares of its size

  bool operator==(const Magnifier&) const = default;
};

/// What is composed out of the frame's displays.
struct ScreenInput {
  uint32_t width = 960, height = 540; // of the window, pixels; pictures are enlarged to it, sharply
  Arrangement arrangement = Arrangement::single;
  double split = 0.5; // a share of the width
  Magnifier magnifier;

  bool operator==(const ScreenInput&) const = default;
};

/// One picture's part of the window. `covered`, of all cells together, is the window; either may be empty
/// beside a bar at the window's edge.
struct ScreenCell {
  ScreenRect covered; // with what is drawn around the picture
  ScreenRect shown;   // of it, what the picture is seen in
  ScreenRect picture; // where the whole picture would be: more than is shown, on the sides of a bar
  size_t mode = 0;    // by place among the frame's modes
};
/// In the order of the modes, of which there is at least one.
std::vector<ScreenCell> cells_of(const ScreenInput& screen, size_t modes);

struct PicturePoint {
  size_t mode = 0;
  glm::dvec2 at{0}; // shares of the picture's size
};
/// What lies there below the magnifier, x and y in pixels of the window; nothing on bars and gaps, and
/// outside. A difference or error is the first mode's.
std::optional<PicturePoint> picture_point(const ScreenInput& screen, size_t modes, double x, double y);

/// A cell's magnifier. It lies across the picture from its region, on the sides of a bar along the bar.
struct ScreenLens {
  ScreenRect inset, region; // both in the window, without what is drawn around them
  glm::ivec2 region_px{0};  // corner of the region in the picture's pixels
  glm::ivec2 region_at{0};  // where in the window that corner is magnified to; outside of a cropped inset
  int block = 1;            // the window's pixels along each side of a magnified one
};
/// None where it is not shown, or the cell is too small for one that leaves its region free. `picture_px`:
/// the size that the picture was drawn at.
std::optional<ScreenLens> lens_in(const ScreenCell& cell, const Magnifier& magnifier, glm::ivec2 picture_px);

} // namespace unghost
