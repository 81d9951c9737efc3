#include "app/measure/stability/matrix.h"

#include <algorithm>
#include <cmath>

#include "renderer/mode_names.h"

namespace unghost {

void worsen(Survival& so_far, double figure, const std::string& where) {
  if (std::isnan(figure)) figure = INFINITY;
  if (so_far.where.empty() || figure > so_far.figure) so_far = {figure, where};
}

size_t wrong_values(const FloatImage& image) {
  constexpr float largest_half = 65504;
  return size_t(std::ranges::count_if(
      image.values, [](float v) { return !std::isfinite(v) || v < 0 || v > largest_half; }));
}

const Excuse* excuse_for(std::string_view mode, std::string_view row) {
  static constexpr Excuse excuses[] = {
      {"blend", "events", frames_after_event,
       "it has nothing against ghosts: they last as long as its average"},
      {"store=plain", "constant", 0.1, "half floats that are cut off stall an average short of its end"},
      {"store=plain", "lookup", 0.1, "half floats that are cut off are up to half a unit too dark"},
  };
  const std::vector<std::string> changes = changes_of_mode(mode);
  const auto found = std::ranges::find_if(excuses, [&](const Excuse& excuse) {
    return excuse.row == row &&
           (excuse.mode == base_of_mode(mode) || std::ranges::count(changes, excuse.mode) > 0);
  });
  return found == std::end(excuses) ? nullptr : found;
}

std::span<const StabilityCase> stability_cases() {
  static constexpr StabilityCase cases[] = {
      {"constant", "The average of a constant scene after thousands of frames, at alphas down to .01",
       "relative", 1e-3, survive_constants},
      {"bad-colour", "A pixel of the lit frame is NaN, an infinity, negative or huge, once",
       "mean FLIP after 32", 1e-3, survive_bad_colours},
      {"bad-motion", "A pixel's motion is NaN, an infinity, negative or huge, once", "mean FLIP after 32",
       1e-3, survive_bad_motion},
      {"bad-depth", "A pixel's depth is, once", "mean FLIP after 32", 1e-3, survive_bad_depth},
      {"bad-history", "A pixel of the history is, once", "mean FLIP after 32", 1e-3, survive_bad_history},
      {"flat", "Neighbourhoods that are a point, a line or a plane: a history in them stays as it is",
       "half-float units", 0, survive_flat_colours},
      {"sun", "A sun of 1e5 beside 1e-3 stays within its neighbourhood: neither halo nor hole",
       "steps of a display", 1, survive_a_sun},
      {"lookup", "Histories are read where the motion says, and not from off the picture", "pixels", 0.01,
       look_up_histories},
      {"sizes", "1x1, 1x720, 4097x3 and others, another in every frame; and nothing in view", "values", 0,
       survive_sizes},
      {"settings", "Every number that a mode reads at both ends of its range, and thresholds that cross",
       "values", 0, survive_settings},
      {"cuts", "What comes after a cut, or after another mode, is what a fresh start makes of it", "linear",
       0, survive_cuts},
      {"thousands", "The ghost after 5,000 frames of a drive is that of a history that is 100 frames old",
       "relative", 0.01, survive_thousands},
      {"events", "An object jumps, appears, stops; the camera turns round: a ghost for one frame at most",
       "frames", 1, survive_events},
      {"chance", "Settings, light, sizes and cameras by chance: finite and in range", "values", 0,
       survive_chance, Takers::by_trial},
      {"rest", "Nothing moves, near, far, wide, narrow and away from the origin", "pixels of motion", 0.01,
       survive_rest_in_extremes, Takers::alone},
      {"motion", "Camera and block move there: motion beside double precision", "pixels", 0.02,
       survive_motion_in_extremes, Takers::alone},
  };
  return cases;
}

bool has_answer(const Setting& column, const Settings& settings, uint32_t answer) {
  const auto given = uint32_t(column.read(settings));
  return column.kind == SettingKind::flags ? (given & answer) != 0 : given == answer;
}

std::vector<ModeRun> stability_modes() {
  std::vector<ModeRun> modes;
  for (const TaaMode& mode : taa_modes())
    if (mode.settings.policy.needs_history()) modes.push_back({std::string(mode.name), mode.settings});
  const auto has = [&](const Setting& column, uint32_t value) {
    return std::ranges::any_of(modes, [&](const ModeRun& run) {
      Settings settings;
      settings.taa = run.taa;
      return has_answer(column, settings, value);
    });
  };
  for (const Setting& column : settings_table()) {
    if (!column.per_mode || column.kind == SettingKind::number) continue;
    for (const Answer& answer : column.answers) {
      if (has(column, answer.value)) continue;
      for (const char* base : {"uncharted", "dop32", "gdk-variance"}) { // the first that it goes with
        Settings settings = settings_for_mode(base);
        column.write(settings, column.kind == SettingKind::flags
                                   ? uint32_t(column.read(settings)) | answer.value
                                   : answer.value);
        const bool has_effect = column.used.met_by(settings);
        if (refusal(settings) || !has_effect || !settings.taa.policy.needs_history()) continue;
        modes.push_back({std::string(column.name) + "=" + answer.name, settings.taa});
        break;
      }
    }
  }
  return modes;
}

} // namespace unghost
