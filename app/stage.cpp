#include "app/stage.h"

#include <algorithm>
#include <cmath>

#include "app/failure.h"
#include "app/rigs.h"
#include "renderer/scene/animation.h"
#include "renderer/scene/bounds.h"
#include "renderer/scene/load.h"
#include "renderer/scene/merge.h"

namespace unghost {
namespace {

constexpr float usual_length_m = float(usual_car_m.z);
constexpr float least_plausible_m = 0.5f, most_plausible_m = 20;
// A model this much wider than long stands across its direction.
constexpr float clearly_wider = 1.05f;

Scene load(const std::filesystem::path& file, const LoadLimits& limits) {
  std::variant<Scene, Refusal> loaded = load_scene(file, limits);
  if (const Refusal* refusal = std::get_if<Refusal>(&loaded))
    throw Failure(refusal->out_of_memory ? Exit::device_lost_or_memory : Exit::input_refused,
                  refusal->sentence());
  return std::get<Scene>(std::move(loaded));
}

// What shapes a model does nothing to a scene of its own, and is not ignored.
void refuse_model_settings(const StageSettings& settings) {
  const StageSettings defaults;
  if (settings.stage == defaults.stage && settings.model_scale == defaults.model_scale &&
      settings.model_yaw_deg == defaults.model_yaw_deg)
    return;
  throw SettingError("stage, model-scale and model-yaw shape a model, and this scene has a road of its own");
}

// Not of a single point, nor of what cannot be scaled to a car with finite numbers.
bool has_size(glm::vec3 size) {
  const float scale = usual_length_m / std::max({size.x, size.y, size.z});
  return scale > 0 && std::isfinite(scale);
}

float scale_of(glm::vec3 size, const StageSettings& settings) {
  if (settings.model_scale > 0) return settings.model_scale;
  if (!has_size(size)) return 1;
  const float largest = std::max({size.x, size.y, size.z});
  return largest >= least_plausible_m && largest <= most_plausible_m ? 1.0f : usual_length_m / largest;
}

/// Puts a model of these bounds on the ground, its middle above the origin, its length along +z.
Trs fit_of(const Bounds& bounds, bool knows_its_front, const StageSettings& settings) {
  const glm::vec3 size = bounds.high - bounds.low;
  const bool across = !knows_its_front && size.x > clearly_wider * size.z;
  const float yaw_deg = settings.model_yaw_deg - (across ? 90.0f : 0.0f);
  Trs fit;
  fit.rotation = glm::angleAxis(glm::radians(yaw_deg), glm::vec3(0, 1, 0));
  fit.scale = glm::vec3(scale_of(size, settings));
  const Bounds turned = transformed(bounds, matrix_of(fit));
  const glm::vec3 middle = (turned.low + turned.high) / 2.0f;
  fit.translation = {-middle.x, -turned.low.y, -middle.z};
  return fit;
}

bool has_tags(const Scene& scene) {
  return std::ranges::any_of(scene.nodes, [](const Node& node) { return node.tag != 0; });
}

/// The surroundings with `model` as their vehicle.
Scene staged_model(Scene surroundings, const Scene& model, const Trs& fit) {
  surroundings.name = model.name;
  surroundings.files = model.files;
  surroundings.vehicle = int(surroundings.nodes.size());
  Node vehicle;
  vehicle.name = "vehicle";
  vehicle.tag = has_tags(model) ? 0 : 1;
  Node fitted = vehicle;
  fitted.name = "fit";
  fitted.parent = surroundings.vehicle;
  fitted.local = fit;
  surroundings.nodes.insert(surroundings.nodes.end(), {vehicle, fitted});
  append(surroundings, model, surroundings.vehicle + 1);
  return surroundings;
}

Scene surroundings_of(const std::filesystem::path& road, Stage stage, const LoadLimits& limits) {
  if (stage == Stage::none) return {};
  Scene scene = load(road, limits);
  return scene.vehicle < 0 ? scene : without(scene, scene.vehicle);
}

} // namespace

Staged build_stage(const std::filesystem::path& file, const std::filesystem::path& road,
                   const StageSettings& settings, const LoadLimits& limits) {
  Staged staged{.scene = load(file, limits), .vehicle = {}};
  if (staged.scene.vehicle >= 0 && staged.scene.track) {
    refuse_model_settings(settings);
  } else {
    const Bounds bounds = scene_bounds(staged.scene);
    if (bounds.empty())
      staged.scene.warnings.push_back("there is nothing in it to draw");
    else if (!has_size(bounds.high - bounds.low))
      staged.scene.warnings.push_back("it has no size, and is drawn as it is");
    const Trs fit = bounds.empty() ? Trs{} : fit_of(bounds, staged.scene.vehicle >= 0, settings);
    staged.scene = staged_model(surroundings_of(road, settings.stage, limits), staged.scene, fit);
  }
  const Bounds vehicle = vehicle_bounds(staged.scene);
  if (!vehicle.empty() && has_size(vehicle.high - vehicle.low)) staged.vehicle = vehicle;
  if (staged.scene.track) staged.track_radius = staged.scene.track->radius;
  return staged;
}

Staged stage_scene(const std::string& scene, const DataFolders& folders, const StageSettings& settings,
                   const Device& device) {
  LoadLimits limits;
  limits.image_side = std::min(limits.image_side, device.largest_image_side());
  return build_stage(scene_file(scene, folders.assets), scene_file(own_scene, folders.assets), settings,
                     limits);
}

RigContext rig_context(const Staged& staged, uint64_t seed, const Settings& settings) {
  return {.seed = seed,
          .track_radius = staged.track_radius,
          .vehicle = staged.vehicle,
          .stage = settings.stage,
          .light = settings.light};
}

} // namespace unghost
