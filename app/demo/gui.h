// Dear ImGui in the window: its context, and its stock backends.
#pragma once

#include "renderer/gpu/swapchain.h"

struct GLFWwindow;

namespace unghost {

class Gui {
public:
  /// Chains itself behind the window's callbacks, which must be there before. `text_scale`: 1 is 13 pixels.
  Gui(Device& device, Swapchain& swapchain, GLFWwindow* window, double text_scale);
  ~Gui();
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  /// Between the two, widgets are described.
  void begin_frame();
  void end_frame();
  /// Whether the panel takes the mouse, or is typed into.
  bool has_mouse() const;
  bool has_keys() const;
  /// After the swapchain has other images.
  void window_changed(const Swapchain& swapchain);

private:
  OwnedDescriptorPool descriptors_;
};

} // namespace unghost
