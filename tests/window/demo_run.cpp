#include "tests/window/demo_run.h"

#include <stdexcept>

#include "tests/app/own_copy.h"

namespace unghost {
namespace {

std::string environment_or(const char* name, const std::string& otherwise) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : otherwise;
}

Words conditions(const Desk& desk) {
  const std::string home = desk.home().string();
  const std::string cache = environment_or("XDG_CACHE_HOME", home);
  return {"env", "-u", "WAYLAND_DISPLAY", "DISPLAY=" + desk.display(), "XDG_CONFIG_HOME=" + home + "/config",
          "XDG_STATE_HOME=" + home + "/state", "XDG_CACHE_HOME=" + home + "/cache",
          // the driver's compiled shaders are no part of what is tested, and take seconds to make
          "MESA_SHADER_CACHE_DIR=" + environment_or("MESA_SHADER_CACHE_DIR", cache + "/mesa"),
          "UNGHOST_FAKE_INPUT=" + desk.gamepads().string(),
          "LD_PRELOAD=" + (folder_of_this_program() / "fake_gamepad" / "libfake_gamepad.so").string(),
          // an address sanitizer wants to be first, and need not be: what is preloaded allocates nothing
          "ASAN_OPTIONS=" + environment_or("ASAN_OPTIONS", "") + ":verify_asan_link_order=0"};
}

Words joined(Words words, const Words& more, const Words& most) {
  words.insert(words.end(), more.begin(), more.end());
  words.insert(words.end(), most.begin(), most.end());
  return words;
}

} // namespace

DemoRun::DemoRun(const Desk& desk, const Words& words, const Words& environment)
    : process_(joined(conditions(desk), environment, words), desk.talk()) {
  std::string said;
  while (ready_.value("event", "") != "ready") {
    const auto line = process_.line();
    if (!line) throw std::runtime_error("it is not ready, but said '" + said + "' and '" + talk() + "'");
    ready_ = parsed(*line);
    said += *line;
  }
  window_ = desk.window();
}

nlohmann::json DemoRun::parsed(const std::string& line) const {
  nlohmann::json object = nlohmann::json::parse(line, nullptr, false);
  if (!object.is_object()) throw std::runtime_error("it printed '" + line + "', which is no JSON object");
  return object;
}

std::optional<nlohmann::json> DemoRun::next_event(Milliseconds limit) {
  const auto line = process_.line(limit);
  return line ? std::optional(parsed(*line)) : std::nullopt;
}

nlohmann::json DemoRun::expect_event(const std::string& action) {
  std::string others;
  while (const auto event = next_event(patience)) {
    const std::string found = event->value("action", "");
    if (found == action) return *event;
    others += " '" + found + "'";
  }
  throw std::runtime_error("no '" + action + "' came, but" + others + "; on standard error: " + talk());
}

nlohmann::json DemoRun::press(const std::string& key, const std::string& action) {
  window().press(key);
  return expect_event(action);
}

nlohmann::json DemoRun::press(Pad& pad, int button, const std::string& action) {
  pad.press(button);
  return expect_event(action);
}

int DemoRun::leave() {
  window().press("Escape");
  return ended();
}

int DemoRun::ended() {
  if (const auto code = process_.exit_code()) return *code;
  throw std::runtime_error("it still runs; on standard error: " + talk());
}

} // namespace unghost
