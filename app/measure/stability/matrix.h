// The matrix of stiff and extreme cases: what every mode must survive, and within which bound.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/measure/film.h"
#include "renderer/renderer.h"
#include "renderer/resolve_alone.h"

namespace unghost {

/// How much of it: in the tests, by default, and over night.
enum class Endurance { brief, usual, long_run };

/// What cases are run on; several may share the work, each on a device of its own.
struct StabilityBench {
  Device& device;
  std::filesystem::path shaders;
  ResolveAlone resolve;                 // by itself, on pictures made by hand
  Renderer blocks;                      // the chequered world of block_world.h
  std::function<const Film&()> asphalt; // our own scene on rig `drive`; loaded when it is first asked for
  Endurance endurance = Endurance::usual;
  uint64_t seed = 1;             // of what is by chance
  std::optional<uint64_t> trial; // this one alone
  size_t share = 0, shares = 1;  // of the trials: every `shares`th one, from `share` on
};

/// What a mode came to: it passes where the figure is at most the case's bound.
struct Survival {
  double figure = 0;
  std::string where; // the worst of it was
};
/// The worse of both; not a number is worst of all.
void worsen(Survival& so_far, double figure, const std::string& where);

/// Who takes part: each mode by itself; trials that draw their modes; or none, where all modes share what the
/// case is about.
enum class Takers { by_mode, by_trial, alone };

/// One row of the matrix; one line in stability_cases().
struct StabilityCase {
  std::string_view name, summary, unit;
  double bound = 0;
  /// A figure a mode, in their order; or the only one.
  std::vector<Survival> (*run)(StabilityBench& bench, std::span<const ModeRun> modes) = nullptr;
  Takers takers = Takers::by_mode;
};
std::span<const StabilityCase> stability_cases();

/// Every row that keeps a history, and each answer that none of them has, in place of that of a row or beside
/// it where there may be several.
std::vector<ModeRun> stability_modes();

/// Whether the settings have that answer, alone or among others.
bool has_answer(const Setting& column, const Settings& settings, uint32_t answer);

/// What a mode cannot survive, and how bad it may get.
struct Excuse {
  std::string_view mode, row;
  double at_most = 0;
  std::string_view why;
};
constexpr uint32_t frames_after_event = 8; // that are looked at in `events`
/// Nothing where there is none.
const Excuse* excuse_for(std::string_view mode, std::string_view row);

/// How many values are not finite, or not in the range of a colour in half floats.
size_t wrong_values(const FloatImage& image);

// The cases, by what they need.
std::vector<Survival> survive_constants(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_bad_colours(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_bad_motion(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_bad_depth(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_bad_history(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_flat_colours(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_a_sun(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> look_up_histories(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_sizes(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_settings(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_cuts(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_thousands(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_events(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_chance(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_rest_in_extremes(StabilityBench& bench, std::span<const ModeRun> modes);
std::vector<Survival> survive_motion_in_extremes(StabilityBench& bench, std::span<const ModeRun> modes);

} // namespace unghost
