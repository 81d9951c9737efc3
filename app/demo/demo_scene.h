// What the demo drives: a scene and what draws it, whole or not at all.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "app/demo/demo_state.h"
#include "app/demo/file_watch.h"
#include "app/rigs.h"
#include "renderer/renderer.h"

namespace unghost {

struct DemoScene {
  RigContext context;
  std::unique_ptr<Renderer> renderer;
  FileWatch files, shaders; // that it was read from, as they were before that
};

/// The state's scene, with its settings. Throws Failure, SettingError and what the device throws.
DemoScene load_demo_scene(Device& device, const DemoState& state);
/// What those who look at a scene call it: a file's name without its folders.
std::string short_name(const std::string& scene);
/// Which of some dropped files is the scene: the first that is called so, as its pictures may come with it;
/// else the first.
std::string scene_among(const std::vector<std::filesystem::path>& dropped);

/// Does it. What went wrong, in a sentence; nothing where nothing did. A device that is lost is thrown on.
std::optional<std::string> fault_of(const std::function<void()>& work);

} // namespace unghost
