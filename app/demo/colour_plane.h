// A plane of a colour space, and in it what a rectification saw and did.
#pragma once

#include <array>

#include <imgui.h>

#include "app/measure/rectification.h"

namespace unghost {

inline const ImVec4 history_ink{1, 0.45f, 0.4f, 1}, rectified_ink{0.45f, 0.9f, 0.5f, 1};

struct Axis {
  int component = 0; // of a colour of the working space
  const char* name = "";
};

struct ColourPlane {
  const Rectification& rectification;
  bool has_history = false;
  std::array<ImU32, 9> inks{}; // the nine colours as they are seen

  /// A square of that width at the cursor, each axis scaled to what is shown, with its ends written below it.
  void draw(Axis across, Axis up, float width) const;
};

} // namespace unghost
