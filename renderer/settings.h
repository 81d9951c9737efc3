// Every setting there is, as plain data with its default in place. The table in settings_table.cpp gives each
// its name, unit, range and source; the command line, the panel, JSON and the pictures' metadata all go
// through that table.
#pragma once

#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "renderer/spelling.h"
#include "renderer/taa_modes.h"
#include "shaders/shared/views.h"

namespace unghost {

// What surrounds a model that is not a whole scene of its own.
#define UNGHOST_STAGES(X) X(stage, asphalt, 0) X(stage, none, 1)

#define UNGHOST_ENUMERATOR(column, answer, value) answer = value,
enum class Stage : uint32_t { UNGHOST_STAGES(UNGHOST_ENUMERATOR) };
enum class View : uint32_t { UNGHOST_VIEWS(UNGHOST_ENUMERATOR) };
#undef UNGHOST_ENUMERATOR

struct LightSettings {
  float sun_azimuth_deg = 35.0f; // added to the rig's
  float sun_elevation_deg = 38.0f;
  float sun_illuminance = 1.0f; // a share of the clear noon sun's
  float sky_luminance = 1.0f;   // a share of the clear sky's
  float exposure_ev = 0.0f;

  bool operator==(const LightSettings&) const = default;
};

struct StageSettings {
  Stage stage = Stage::asphalt;
  float model_scale = 0.0f;   // 0: found from the model's bounds
  float model_yaw_deg = 0.0f; // turns a foreign model about y
  float speed = 1.0f;         // scales a rig's motion

  bool operator==(const StageSettings&) const = default;
};

struct Settings {
  TaaSettings taa;
  LightSettings light;
  StageSettings stage;
  View view = View::colour;
  bool keep_all = false;

  bool operator==(const Settings&) const = default;
};

/// One resolve among those of a frame. Its history belongs to its place in the list.
struct ModeRun {
  std::string name; // of the row; what pictures are labelled with
  TaaSettings taa;

  bool operator==(const ModeRun&) const = default;
};

/// A setting's words were wrong; `what()` is the sentence, with the nearest known name or the range.
struct SettingError : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

enum class SettingKind { number, choice, flags };

/// When a setting has any effect, and why it has none otherwise.
struct Condition {
  bool (*holds)(const Settings&) = nullptr; // null: always
  std::string_view otherwise{};

  bool met_by(const Settings& settings) const { return holds == nullptr || holds(settings); }
};

/// One row of the table of settings.
struct Setting {
  std::string_view name{}, unit{}, summary{}, source{};
  float low = 0, high = 0; // number: both are allowed
  Condition used{};
  SettingKind kind = SettingKind::number;
  bool per_mode = false;             // part of TaaSettings: each mode of a comparison has its own
  std::span<const Answer> answers{}; // choice, flags: spelled as on the command line
  double (*read)(const Settings&) = nullptr;
  void (*write)(Settings&, double value) = nullptr;

  /// As text, exactly as `set` reads it; numbers as the shortest text that reads back to the same bits.
  std::string get(const Settings& settings) const;
  /// Throws SettingError, which names the range or the nearest known answer.
  void set(Settings& settings, std::string_view value) const;
};

std::span<const Setting> settings_table();
/// The row of that name. Throws SettingError with the nearest name.
const Setting& find_setting(std::string_view name);
/// `key=value`. Throws SettingError.
void apply_setting(Settings& settings, std::string_view assignment);
/// The default settings with the row of that name. Throws SettingError for a name that no row has.
Settings settings_for_mode(std::string_view mode);
/// A row, and settings of its own for it: `rgb`, or `rgb:alpha=0.05:dilation=centre`, which is also its name.
/// Of several flags the words are joined by `+`. Throws SettingError, also for a setting that is said
/// twice, or that the row has no use for.
ModeRun mode_run(const std::string& text);
/// Why these settings cannot work together, in one sentence; nothing where they can.
std::optional<std::string> refusal(const Settings& settings);

enum class SettingsPart { all, per_mode, shared };
/// Name to value, numbers as numbers; reading it back gives the same settings.
nlohmann::json settings_json(const Settings& settings, SettingsPart part = SettingsPart::all);
/// Sets what the object names. Throws SettingError for an unknown name, a wrong type or a value out of range.
void apply_settings_json(Settings& settings, const nlohmann::json& object);

} // namespace unghost
