// Every setting there is, as plain data with its default in place. The table in settings.cpp gives each its name,
// unit, range and source; the command line, the panel, JSON and the pictures' metadata all go through that table.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "renderer/taa_modes.h"
#include "shaders/shared/views.h"

namespace unghost {

#define UNGHOST_ENUMERATOR(column, answer, value) answer = value,
enum class View : uint32_t { UNGHOST_VIEWS(UNGHOST_ENUMERATOR) };
#undef UNGHOST_ENUMERATOR

/// What surrounds a model that is not a whole scene of its own.
enum class Stage : uint32_t { asphalt, none };

struct TaaSettings {
  TaaPolicy policy;
  float alpha = 0.1f;                // weight of the current frame
  float jitter_scale = 1.0f;         // 0 to 1, of a pixel
  float motion_threshold_px = 1.0f;  // near and moving: faster than this
  float near_m = 8.0f;               // near and moving: nearer than this, all of the history goes
  float far_m = 16.0f;               // and beyond this, none

  bool operator==(const TaaSettings&) const = default;
};

struct LightSettings {
  float sun_azimuth_deg = 35.0f;  // added to the rig's
  float sun_elevation_deg = 38.0f;
  float sun_illuminance = 1.0f;   // a share of the clear noon sun's
  float sky_luminance = 1.0f;     // a share of the clear sky's
  float exposure_ev = 0.0f;
  float shadow_softness_m = 0.06f;  // radius of the shadow filter on the ground
};

struct StageSettings {
  Stage stage = Stage::asphalt;
  float model_scale = 0.0f;     // 0: found from the model's bounds
  float model_yaw_deg = 0.0f;   // turns a foreign model about y
  float speed = 1.0f;           // scales a rig's motion
};

struct Settings {
  TaaSettings taa;
  LightSettings light;
  StageSettings stage;
  View view = View::colour;
};

/// A setting's words were wrong; `what()` is the sentence, with the nearest known name or the range.
struct SettingError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

enum class SettingKind { number, choice, flags };

/// One row of the table of settings.
struct Setting {
  std::string_view name, unit, summary, source;
  SettingKind kind = SettingKind::number;
  float low = 0, high = 0;                  // number
  std::vector<std::string> choices;         // choice, flags: spelled as on the command line
  std::string (*get)(const Settings&);      // as text, exactly as `set` reads it
  void (*set)(Settings&, std::string_view value);  // throws SettingError
};

std::span<const Setting> settings_table();
/// `key=value`. Throws SettingError.
void apply_setting(Settings& settings, std::string_view assignment);
/// The default settings with the row of that name. Throws SettingError for a name that no row has.
Settings settings_for_mode(std::string_view mode);
/// Name to value, numbers as numbers; reading it back gives the same settings.
nlohmann::json settings_json(const Settings& settings);
/// The known word nearest to `word` by edit distance; empty where none is near.
std::string nearest_word(std::string_view word, std::span<const std::string> known);

}  // namespace unghost
