// The driver and the validation layer keep some memory until the process ends, and are unloaded before the
// leak sanitizer looks, which then can't tell whose it was. Held in place they can be named, and only they
// are excused.
#include <initializer_list>

#include <dlfcn.h>

namespace {

const bool held = [] {
  for (const char* library :
       {"libvulkan_lvp.so", "libVkLayer_khronos_validation.so", "libVkLayer_MESA_device_select.so"})
    dlopen(library, RTLD_NOW | RTLD_NODELETE);
  return true;
}();

} // namespace

extern "C" const char* __lsan_default_suppressions() {
  return held ? "leak:libvulkan_lvp.so\nleak:libVkLayer_\nleak:libLLVM\nleak:libvulkan.so\n" : "";
}

// A program that is run by a test says its own sentences only.
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
