// The scene that is drawn: ours as it is, a foreign scene as it is, or a foreign model on our road.
#pragma once

#include <filesystem>

#include "app/paths.h"
#include "app/rigs.h"
#include "renderer/gpu/device.h"
#include "renderer/scene/load.h"

namespace unghost {

struct Staged {
  Scene scene;
  Bounds vehicle;            // of the vehicle, in its own frame; metres
  double track_radius = 150; // metres
};

/// `file` is a scene of its own where it has a vehicle and a track; else it is a model, and takes the place
/// of the car in `road`. Throws Failure(input_refused) with the file and the reason.
Staged build_stage(const std::filesystem::path& file, const std::filesystem::path& road,
                   const StageSettings& settings, const LoadLimits& limits = {});

/// The scene of that name on its stage, with images that `device` can hold.
Staged stage_scene(const std::string& scene, const DataFolders& folders, const StageSettings& settings,
                   const Device& device);
/// What rigs are fitted to there.
RigContext rig_context(const Staged& staged, uint64_t seed, const Settings& settings);

} // namespace unghost
