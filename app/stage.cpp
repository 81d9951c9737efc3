#include "app/stage.h"

#include "app/failure.h"
#include "renderer/scene/animation.h"
#include "renderer/scene/bounds.h"
#include "renderer/scene/load.h"

namespace unghost {
namespace {

Scene load(const std::filesystem::path& file) {
  std::variant<Scene, Refusal> loaded = load_scene(file);
  if (const Refusal* refusal = std::get_if<Refusal>(&loaded)) throw Failure(Exit::input_refused, refusal->sentence());
  return std::get<Scene>(std::move(loaded));
}

// In the frame of the vehicle's own node, wherever the file has parked it.
Bounds vehicle_bounds(const Scene& scene) {
  const glm::dmat4 world = world_matrices(scene, default_pose(scene))[size_t(scene.vehicle)];
  return transformed(node_bounds(scene, scene.vehicle), glm::inverse(world));
}

}  // namespace

Staged build_stage(const std::filesystem::path& file, const std::filesystem::path&, const StageSettings&) {
  Staged staged{.scene = load(file), .vehicle = {}};
  if (staged.scene.vehicle < 0 || !staged.scene.track)
    throw Failure(Exit::input_refused, file.string() + ": it has no vehicle and no track of its own");
  staged.vehicle = vehicle_bounds(staged.scene);
  staged.track_radius = staged.scene.track->radius;
  return staged;
}

}  // namespace unghost
