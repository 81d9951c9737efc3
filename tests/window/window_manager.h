// What a window manager would do, where none runs.
#pragma once

#include <string>

namespace unghost {

/// Makes a window iconic, or normal again, as ICCCM 4.1.4 has it: its state is told in WM_STATE, which GLFW
/// listens to, and it is shown or not. xdotool only hides it, of which GLFW takes no notice.
void set_iconic(const std::string& display, unsigned long window, bool iconic);

} // namespace unghost
