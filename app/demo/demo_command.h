// What is shown, as a command line that draws it.
#pragma once

#include <string>

#include "app/demo/demo_state.h"

namespace unghost {

/// `unghost capture ...`, or `compare` where modes stand beside one another; as the rig has the camera.
/// Throws std::invalid_argument with the reason where no line draws the same: --set reaches all modes of a
/// comparison that use the setting, so that two which differ from their rows by unlike values are beyond it.
std::string command_of(const DemoState& state);

} // namespace unghost
