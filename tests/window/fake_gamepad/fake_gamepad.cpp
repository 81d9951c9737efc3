// Shows GLFW gamepads that are FIFOs: where there is no uinput, a test can still plug one in. Preloaded, it
// answers those calls by which GLFW (3.3.8, linux_joystick.c) knows gamepads, as the kernel's evdev would for
// an Xbox 360 pad, and leaves all others alone. The folder that UNGHOST_FAKE_INPUT names stands in for
// /dev/input: a FIFO `eventN` made there is a gamepad plugged in, and one removed is a gamepad unplugged.
// What is written to it are `input_event`s, as the kernel would send them.
//
// One thing is other than in the kernel: a program sees one report (what stands before a SYN_REPORT) between
// two polls for events, and the next one after the second poll. GLFW reads all that waits when it is asked
// for a gamepad's state, so a button pressed and released within a slow frame would never have been down.
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <string_view>

#include <cstdarg>
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/input.h>
#include <sys/inotify.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace {

/// A gamepad that GLFW holds open; free where `descriptor` is -1. Atomic, as other threads close and read,
/// too.
struct Pad {
  std::atomic<int> descriptor = -1;
  unsigned seen_at = 0; // the poll after which its last report was read
  int axes[ABS_CNT] = {};
};
Pad pads[4];
std::atomic<int> watch = -1; // GLFW's inotify descriptor
unsigned polls = 1;          // for events

/// What this library hides: libc's, or a sanitizer's, that checks the same buffers.
template <class Function> Function* hidden(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

Pad* pad_of(int descriptor) {
  for (Pad& pad : pads)
    if (descriptor >= 0 && pad.descriptor == descriptor) return &pad;
  return nullptr;
}

/// Where a path below /dev/input really is; other paths as they are. `place` holds the result.
const char* redirected(const char* path, char (&place)[PATH_MAX]) {
  constexpr std::string_view devices = "/dev/input";
  const char* folder = std::getenv("UNGHOST_FAKE_INPUT");
  if (folder == nullptr || !std::string_view(path).starts_with(devices)) return path;
  const char* rest = path + devices.size();
  if (*rest != '\0' && *rest != '/') return path;
  std::snprintf(place, sizeof(place), "%s%s", folder, rest);
  return place;
}

/// The bits that EVIOCGBIT asks for: kinds of events, buttons, axes. Those of an Xbox 360 pad, and in the
/// order of their codes they are b0 to b10, a0 to a5 and h0 of GLFW's mapping table.
int fill_bits(int kind, unsigned char* bits, size_t size) {
  const auto set = [&](std::initializer_list<int> codes) {
    for (const int code : codes)
      if (size_t(code / 8) < size) bits[code / 8] |= 1 << code % 8;
  };
  std::memset(bits, 0, size);
  if (kind == 0) set({EV_SYN, EV_KEY, EV_ABS});
  if (kind == EV_KEY)
    set({BTN_A, BTN_B, BTN_X, BTN_Y, BTN_TL, BTN_TR, BTN_SELECT, BTN_START, BTN_MODE, BTN_THUMBL,
         BTN_THUMBR});
  if (kind == EV_ABS) set({ABS_X, ABS_Y, ABS_Z, ABS_RX, ABS_RY, ABS_RZ, ABS_HAT0X, ABS_HAT0Y});
  return int(size);
}

/// Sticks are signed 16-bit, triggers bytes, the directional pad -1 to 1; all rest at 0.
input_absinfo range_of(int axis) {
  if (axis == ABS_Z || axis == ABS_RZ) return {.maximum = 255};
  if (axis == ABS_HAT0X || axis == ABS_HAT0Y) return {.minimum = -1, .maximum = 1};
  return {.minimum = -32768, .maximum = 32767};
}

/// GLFW asks these when it opens a device: is it a gamepad, which (the GUID that it looks up in its table is
/// made of the numbers, not of the name), and how far do its axes go? It asks where they are after every
/// report, too, and believes that more than the report.
int answer(const Pad& pad, unsigned long request, void* result) {
  const unsigned number = _IOC_NR(request), size = _IOC_SIZE(request);
  if (_IOC_TYPE(request) == 'E' && number >= _IOC_NR(EVIOCGBIT(0, 0)) &&
      number <= _IOC_NR(EVIOCGBIT(EV_MAX, 0)))
    return fill_bits(int(number - _IOC_NR(EVIOCGBIT(0, 0))), static_cast<unsigned char*>(result), size);
  if (_IOC_TYPE(request) == 'E' && number >= _IOC_NR(EVIOCGABS(0)) && number <= _IOC_NR(EVIOCGABS(ABS_MAX))) {
    const int axis = int(number - _IOC_NR(EVIOCGABS(0)));
    auto& info = *static_cast<input_absinfo*>(result);
    info = range_of(axis);
    info.value = pad.axes[axis];
    return 0;
  }
  if (request == EVIOCGID) {
    *static_cast<input_id*>(result) = {
        .bustype = BUS_USB, .vendor = 0x045e, .product = 0x028e, .version = 0x0104};
    return 0;
  }
  if (request == EVIOCGNAME(size))
    return std::snprintf(static_cast<char*>(result), size, "Microsoft X-Box 360 pad");
  errno = EINVAL;
  return -1;
}

} // namespace

extern "C" {

// GLFW lists /dev/input once, when it starts, for gamepads that are there.
DIR* opendir(const char* path) {
  char place[PATH_MAX];
  return hidden<DIR*(const char*)>("opendir")(redirected(path, place));
}

// It watches /dev/input for files that come and go.
int inotify_add_watch(int descriptor, const char* path, uint32_t mask) noexcept {
  char place[PATH_MAX];
  const char* real = redirected(path, place);
  if (real == place) watch = descriptor;
  return hidden<int(int, const char*, uint32_t)>("inotify_add_watch")(descriptor, real, mask);
}

// It opens every `eventN`.
int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(more, mode_t) : 0;
  va_end(more);
  char place[PATH_MAX];
  const char* real = redirected(path, place);
  // for writing, too: a FIFO without a writer is at its end, where GLFW would read for ever
  if (real == place) flags = (flags & ~O_ACCMODE) | O_RDWR;
  const int descriptor = hidden<int(const char*, int, ...)>("open")(real, flags, mode);
  if (real == place && descriptor >= 0)
    for (Pad& pad : pads)
      if (int free = -1; pad.descriptor.compare_exchange_strong(free, descriptor)) {
        std::memset(pad.axes, 0, sizeof(pad.axes));
        pad.seen_at = 0;
        break;
      }
  return descriptor;
}

// It closes one that was removed; the number may be a socket's next.
int close(int descriptor) {
  if (Pad* pad = pad_of(descriptor)) pad->descriptor = -1;
  if (descriptor == watch) watch = -1;
  return hidden<int(int)>("close")(descriptor);
}

// It asks what a device is.
int ioctl(int descriptor, unsigned long request, ...) noexcept {
  va_list more;
  va_start(more, request);
  void* argument = va_arg(more, void*);
  va_end(more);
  if (const Pad* pad = pad_of(descriptor)) return answer(*pad, request, argument);
  return hidden<int(int, unsigned long, ...)>("ioctl")(descriptor, request, argument);
}

// It reads its watch once a poll for events, and a gamepad, event by event until there is none, whenever the
// program asks for its state.
ssize_t read(int descriptor, void* buffer, size_t size) {
  Pad* pad = pad_of(descriptor);
  if (descriptor >= 0 && descriptor == watch) polls++;
  if (pad != nullptr && pad->seen_at == polls) {
    errno = EAGAIN;
    return -1;
  }
  const ssize_t done = hidden<ssize_t(int, void*, size_t)>("read")(descriptor, buffer, size);
  const auto* event = static_cast<const input_event*>(buffer);
  if (pad == nullptr || done != sizeof(*event)) return done;
  if (event->type == EV_SYN) pad->seen_at = polls;
  if (event->type == EV_ABS && event->code < ABS_CNT) pad->axes[event->code] = event->value;
  return done;
}

} // extern "C"
