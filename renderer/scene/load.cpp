#include "renderer/scene/load.h"

#include <new>

#include "renderer/scene/gltf_animations.h"
#include "renderer/scene/gltf_images.h"
#include "renderer/scene/gltf_lights.h"
#include "renderer/scene/gltf_materials.h"
#include "renderer/scene/gltf_meshes.h"
#include "renderer/scene/gltf_nodes.h"
#include "renderer/scene/gltf_schema.h"
#include "renderer/scene/wheels.h"

namespace unghost {

namespace {

using namespace gltf;

/// Keeps the default material, which is the last, only where something uses it or nothing else is there.
void drop_unused_default(Scene& scene) {
  const int last = int(scene.materials.size()) - 1;
  if (last == 0) return;
  for (const Mesh& mesh : scene.meshes) {
    for (const Primitive& primitive : mesh.primitives) {
      if (primitive.material == last) return;
    }
  }
  scene.materials.pop_back();
}

Scene read_scene(const std::filesystem::path& file, const LoadLimits& limits) {
  const std::vector<uint8_t> bytes = read_file(file, limits.file_bytes);
  const Container container = open_container(bytes);
  Warnings warnings;
  Json document = parse_json(container.json, limits, warnings);
  check_schema(document);

  Folder folder(file.parent_path(), limits);
  const Accessors accessors(document, container, folder, limits);
  Images images({document, folder, accessors, warnings}, limits);
  const tinygltf::Model model = read_model(document);

  Scene scene;
  scene.materials = read_materials(model, images, warnings);
  scene.images = images.take();
  read_meshes(scene, model, accessors, limits, warnings);
  drop_unused_default(scene);
  scene.cameras = read_cameras(model, warnings);
  scene.lights = read_lights(model, warnings);
  const std::vector<int> places = read_nodes(scene, model, limits, warnings);
  scene.animations = read_animations(scene, model, accessors, places, warnings);
  if (scene.name.empty()) scene.name = file.stem().string();
  scene.warnings = warnings.take();
  scene.files = folder.files();
  scene.files.push_back(file);
  find_wheels_by_name(scene);
  return scene;
}

} // namespace

std::string Refusal::sentence() const {
  return file + ": " + why + (pointer.empty() ? "" : " (at " + pointer + ")");
}

std::variant<Scene, Refusal> load_scene(const std::filesystem::path& file, const LoadLimits& limits) {
  const auto refusal = [&](std::string why, std::string pointer = {}) {
    return Refusal{.file = file.string(), .pointer = std::move(pointer), .why = std::move(why)};
  };
  try {
    return read_scene(file, limits);
  } catch (Refused& refused) {
    return refusal(std::move(refused.why), std::move(refused.pointer));
  } catch (const FileProblem& problem) {
    return refusal(problem.what());
  } catch (const std::bad_alloc&) {
    Refusal large = refusal("there is not enough memory for it");
    large.out_of_memory = true;
    return large;
  } catch (const std::exception& error) { // of a library, about something that should have been checked above
    return refusal(std::string("cannot be read: ") + printable(error.what()));
  }
}

} // namespace unghost
