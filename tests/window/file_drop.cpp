#include "tests/window/file_drop.h"

#include <cctype>
#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <thread>

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include "tests/window/process.h"

namespace unghost {
namespace {

using Clock = std::chrono::steady_clock;

constexpr long version = 5;

/// From the moment in which the mouse enters the window until that has taken what was dropped.
class Drag {
public:
  Drag(const std::string& display, Window target, std::string uris)
      : display_(XOpenDisplay(display.c_str()), &XCloseDisplay), target_(target), uris_(std::move(uris)) {
    if (!display_) throw std::runtime_error("no display " + display);
    source_ = XCreateSimpleWindow(x(), DefaultRootWindow(x()), 0, 0, 1, 1, 0, 0, 0);
    XSelectInput(x(), source_, PropertyChangeMask);
    if (!understands()) throw std::runtime_error("the window takes nothing that is dropped on it");
    time_ = now();
    XSetSelectionOwner(x(), atom("XdndSelection"), source_, time_);
  }

  void drop() {
    tell("XdndEnter", version << 24, long(atom("text/uri-list")), long(atom("text/plain")));
    tell("XdndPosition", 0, middle(), long(time_), long(atom("XdndActionCopy")));
    if ((answer("XdndStatus").data.l[1] & 1) == 0) {
      tell("XdndLeave");
      throw std::runtime_error("the window does not take files");
    }
    tell("XdndDrop", 0, long(time_));
    // 1 would be the protocol's word; GLFW 3.3 says how many bytes it took
    if (answer("XdndFinished").data.l[1] == 0) throw std::runtime_error("the window took no file");
  }

private:
  Display* x() const { return display_.get(); }
  Atom atom(const char* name) const { return XInternAtom(x(), name, False); }

  bool understands() const {
    Atom type = None;
    int format = 0;
    unsigned long count = 0, left = 0;
    unsigned char* bytes = nullptr;
    XGetWindowProperty(x(), target_, atom("XdndAware"), 0, 1, False, XA_ATOM, &type, &format, &count, &left,
                       &bytes);
    const bool does = count == 1 && *reinterpret_cast<const Atom*>(bytes) >= Atom(version);
    if (bytes != nullptr) XFree(bytes);
    return does;
  }

  /// The server's time, which comes with every change of a property.
  Time now() const {
    XChangeProperty(x(), source_, XA_WM_NAME, XA_STRING, 8, PropModeAppend, nullptr, 0);
    XEvent event;
    XWindowEvent(x(), source_, PropertyChangeMask, &event);
    return event.xproperty.time;
  }

  /// Of the window, on the screen, as two halves of a word.
  long middle() const {
    XWindowAttributes of{};
    Window child = None;
    int left = 0, top = 0;
    XGetWindowAttributes(x(), target_, &of);
    XTranslateCoordinates(x(), target_, of.root, of.width / 2, of.height / 2, &left, &top, &child);
    return long(left) << 16 | long(top);
  }

  void tell(const char* what, long one = 0, long two = 0, long three = 0, long four = 0) const {
    XEvent event{};
    event.xclient = {.type = ClientMessage,
                     .window = target_,
                     .message_type = atom(what),
                     .format = 32,
                     .data = {.l = {long(source_), one, two, three, four}}};
    XSendEvent(x(), target_, False, NoEventMask, &event);
    XFlush(x());
  }

  void hand_over(const XSelectionRequestEvent& asked) const {
    XEvent event{};
    event.xselection = {.type = SelectionNotify,
                        .requestor = asked.requestor,
                        .selection = asked.selection,
                        .target = asked.target,
                        .property = None,
                        .time = asked.time};
    if (asked.target == atom("text/uri-list")) {
      XChangeProperty(x(), asked.requestor, asked.property, asked.target, 8, PropModeReplace,
                      reinterpret_cast<const unsigned char*>(uris_.data()), int(uris_.size()));
      event.xselection.property = asked.property;
    }
    XSendEvent(x(), asked.requestor, False, NoEventMask, &event);
    XFlush(x());
  }

  XClientMessageEvent answer(const char* what) const {
    const Atom wanted = atom(what);
    for (const auto until = Clock::now() + patience; Clock::now() < until;) {
      if (XPending(x()) == 0) {
        std::this_thread::sleep_for(Milliseconds(5));
        continue;
      }
      XEvent event;
      XNextEvent(x(), &event);
      if (event.type == SelectionRequest) hand_over(event.xselectionrequest);
      if (event.type == ClientMessage && event.xclient.message_type == wanted) return event.xclient;
    }
    throw std::runtime_error(std::string("no ") + what + " came");
  }

  std::unique_ptr<Display, int (*)(Display*)> display_;
  Window target_, source_ = None;
  std::string uris_;
  Time time_ = CurrentTime;
};

} // namespace

std::string uri_list(const std::vector<std::filesystem::path>& files) {
  std::string list;
  for (const std::filesystem::path& file : files) {
    list += "file://";
    for (const unsigned char c : file.string()) {
      char code[4];
      std::snprintf(code, sizeof(code), "%%%02X", c);
      const bool plain =
          std::isalnum(c) != 0 || std::string_view("/-._~").find(char(c)) != std::string_view::npos;
      list += plain ? std::string(1, char(c)) : code;
    }
    list += "\r\n";
  }
  return list;
}

void drop_files(const std::string& display, unsigned long window,
                const std::vector<std::filesystem::path>& files) {
  Drag(display, window, uri_list(files)).drop();
}

} // namespace unghost
