// What the window does beside its picture.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/demo/action_rows.h"

namespace unghost {

// clang-format off
std::vector<Action> window_rows() {
  return {
    {"full screen", GLFW_KEY_F11, false, no_button, "Full screen, or a window", request<&DemoRequests::full_screen>},
    {"screenshot", GLFW_KEY_F12, false, no_button, "Take a picture of what is shown", request<&DemoRequests::screenshot>},
    toggles<&DemoState::keys>({"keys", GLFW_KEY_H, false, no_button, "Show or hide what the keys do"}),
    toggles<&DemoState::hidden>({"only the picture", GLFW_KEY_U, false, no_button, "Hide everything else, or show it"}),
  };
}
// clang-format on

} // namespace unghost
