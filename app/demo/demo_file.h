// What lasts of the demo from run to run: one JSON file of the person's.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/demo/demo_state.h"

namespace unghost {

/// Settings, rig, modes, what is shown of them, and bookmarks, but neither the scene nor the camera nor a
/// pause. Of settings, what differs from the defaults, and of modes, what differs from their rows.
nlohmann::json demo_json(const DemoState& state);
/// What the object does not name stays as it is. Throws SettingError with what is wrong, and then leaves the
/// state as it was.
void apply_demo_json(DemoState& state, const nlohmann::json& object);

/// Empty where there is no home.
std::filesystem::path config_file();

struct LoadedDemo {
  DemoState state;       // the defaults, where there is no file or a broken one
  std::string complaint; // about a broken one; else empty
};
LoadedDemo load_demo(const std::filesystem::path& file);
/// The whole file, or none; its folder is made. Throws Failure(failed).
void save_demo(const DemoState& state, const std::filesystem::path& file);

} // namespace unghost
