#include "app/demo/demo_scene.h"

#include <algorithm>
#include <new>

#include "app/failure.h"
#include "app/shot.h"
#include "app/stage.h"
#include "renderer/gpu/device.h"
#include "renderer/gpu/shader_files.h"

namespace unghost {
namespace {

bool is_called_a_scene(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return extension == ".glb" || extension == ".gltf";
}

} // namespace

DemoScene load_demo_scene(Device& device, const DemoState& state) {
  if (!is_utf8(state.scene)) throw Failure(Exit::input_refused, "the scene's name is not UTF-8");
  const DataFolders folders = find_data_folders();
  DemoScene loaded;
  loaded.files.add({scene_file(state.scene, folders.assets)}); // also where it cannot be read
  loaded.shaders.add({folders.shaders / list_of_sums});        // which are compiled before it
  Staged staged = stage_scene(state.scene, folders, state.settings.stage, device);
  loaded.files.add(staged.scene.files);
  loaded.context = rig_context(staged, state.seed, state.settings);
  loaded.renderer = std::make_unique<Renderer>(device, folders.shaders, std::move(staged.scene));
  loaded.renderer->reload_shaders(); // all of them, so that no frame depends on a folder that changes
  return loaded;
}

std::string short_name(const std::string& scene) {
  const std::filesystem::path path(scene);
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

std::string scene_among(const std::vector<std::filesystem::path>& dropped) {
  const auto found = std::ranges::find_if(dropped, is_called_a_scene);
  return (found == dropped.end() ? dropped.front() : *found).string();
}

std::optional<std::string> fault_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const GpuError& error) {
    if (error.fault == GpuFault::lost) throw;
    return error.what();
  } catch (const std::bad_alloc&) {
    return "out of memory; something smaller may do";
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

} // namespace unghost
