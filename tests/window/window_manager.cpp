#include "tests/window/window_manager.h"

#include <stdexcept>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace unghost {

void set_iconic(const std::string& name, unsigned long window, bool iconic) {
  Display* display = XOpenDisplay(name.c_str());
  if (display == nullptr) throw std::runtime_error("no display " + name);
  const Atom property = XInternAtom(display, "WM_STATE", False);
  const long state[] = {iconic ? IconicState : NormalState, None}; // and no icon
  XChangeProperty(display, window, property, property, 32, PropModeReplace,
                  reinterpret_cast<const unsigned char*>(state), 2);
  if (iconic)
    XUnmapWindow(display, window);
  else
    XMapWindow(display, window);
  XSync(display, False);
  XCloseDisplay(display);
}

} // namespace unghost
