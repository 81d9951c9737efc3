#include "app/shot.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/failure.h"
#include "app/files.h"
#include "app/png_file.h"
#include "app/rigs.h"
#include "app/version.h"

namespace unghost {
namespace {

using nlohmann::json;

constexpr size_t settings_file_limit = 256 << 20;
constexpr const char* default_mode = "grand-tour";
// The ghost itself, and the two steps by which the article gets rid of it.
const std::vector<std::string> default_comparison = {"off", "blend", "uncharted", "grand-tour"};

ModeRun mode_run(const std::string& name) { return {.name = name, .taa = settings_for_mode(name).taa}; }

Settings settings_of(const ModeRun& run) {
  Settings settings;
  settings.taa = run.taa;
  return settings;
}

std::vector<ModeRun> default_modes(const CommandRow& command) {
  std::vector<ModeRun> runs;
  if (command.options & one_mode) return {mode_run(default_mode)};
  if (command.options & figures)
    for (const TaaMode& row : taa_modes()) runs.push_back(mode_run(std::string(row.name)));
  else
    for (const std::string& name : default_comparison) runs.push_back(mode_run(name));
  return runs;
}

json parse_settings_file(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = read_file(path, settings_file_limit);
  std::string text(bytes.begin(), bytes.end());
  if (is_png(bytes)) {
    std::optional<std::string> found = text_in_png(bytes);
    if (!found) throw Failure(Exit::input_refused, path.string() + " carries no settings of unghost");
    text = std::move(*found);
  }
  const json parsed = json::parse(text, nullptr, false);
  if (!parsed.is_object())
    throw Failure(Exit::input_refused, path.string() + " is no JSON object of settings");
  return parsed;
}

void read_modes(const json& file, Shot& shot, const CommandRow& command) {
  std::vector<ModeRun> runs;
  for (const json& entry : file.value("modes", json::array())) {
    Settings settings;
    apply_settings_json(settings, entry.at("settings"));
    runs.push_back({.name = entry.at("name").get<std::string>(), .taa = settings.taa});
  }
  if ((command.options & many_modes) && !runs.empty()) shot.modes = runs;
  if ((command.options & one_mode) && file.contains("mode"))
    shot.modes = {{.name = file.at("mode").get<std::string>(), .taa = shot.settings.taa}};
}

// What a picture carries.
void apply_shot(const json& file, Shot& shot, const CommandRow& command) {
  apply_settings_json(shot.settings, file.at("settings"));
  shot.scene = file.value("scene", shot.scene);
  shot.rig = file.value("rig", shot.rig);
  shot.seed = file.value("seed", shot.seed);
  shot.frames = file.value("frames", shot.frames);
  shot.crops = file.value("crops", shot.crops);
  if (shot.frames - 1 >= most_frames)
    throw SettingError("frames are from 1 to " + std::to_string(most_frames));
  if (file.contains("size")) shot.size = picture_size(file.at("size").get<std::string>());
  read_modes(file, shot, command);
}

// Names and values, for every mode.
void apply_plain_settings(const json& file, Shot& shot) {
  apply_settings_json(shot.settings, file);
  for (ModeRun& run : shot.modes) {
    Settings settings = settings_of(run);
    for (const auto& [name, value] : file.items())
      if (find_setting(name).per_mode) apply_settings_json(settings, {{name, value}});
    run.taa = settings.taa;
  }
}

void apply_words(const CommandLine& line, Shot& shot) {
  if (line.scene) shot.scene = *line.scene;
  if (line.rig) shot.rig = *line.rig;
  if (line.seed) shot.seed = *line.seed;
  if (line.size) shot.size = *line.size;
  if (line.frames) shot.frames = *line.frames;
  if (line.crops) shot.crops = *line.crops;
  if (line.mode) shot.modes = {mode_run(*line.mode)};
  if (line.modes.empty()) return;
  shot.modes.clear();
  for (const std::string& name : line.modes) shot.modes.push_back(mode_run(name));
}

// `words` are applied between a shot of the file, which they win over, and plain settings, which need the
// modes.
void apply_file_and_words(const CommandLine& line, Shot& shot) {
  if (line.settings.empty()) return apply_words(line, shot);
  const json file = parse_settings_file(line.settings);
  const bool is_shot = file.contains("settings");
  const auto from_file = [&](auto&& apply) {
    try {
      apply();
    } catch (const std::exception& error) { // a setting, a size or a type in it is wrong
      throw Failure(Exit::input_refused, line.settings.string() + ": " + error.what());
    }
  };
  if (is_shot) from_file([&] { apply_shot(file, shot, *line.command); });
  apply_words(line, shot);
  if (!is_shot) from_file([&] { apply_plain_settings(file, shot); });
}

// An assignment reaches the modes that it has an effect on, and is refused where it has one on none.
void apply_assignments(const CommandLine& line, Shot& shot) {
  for (const std::string& assignment : line.assignments) apply_setting(shot.settings, assignment);
  std::vector<Settings> asked;
  for (const ModeRun& run : shot.modes) {
    Settings& settings = asked.emplace_back(shot.settings);
    settings.taa = run.taa;
    for (const std::string& assignment : line.assignments) apply_setting(settings, assignment);
  }
  for (const std::string& assignment : line.assignments) {
    const Setting& row = find_setting(assignment.substr(0, assignment.find('=')));
    bool used = false;
    for (size_t i = 0; i < asked.size(); ++i)
      if (!row.used.holds || row.used.holds(asked[i]))
        used = true;
      else if (row.per_mode)
        row.write(asked[i], row.read(settings_of(shot.modes[i])));
    if (!used) throw SettingError(assignment + " has no effect: " + std::string(row.used.otherwise));
  }
  for (size_t i = 0; i < asked.size(); ++i) {
    if (const auto why = refusal(asked[i])) throw SettingError(shot.modes[i].name + ": " + *why);
    shot.modes[i].taa = asked[i].taa;
  }
}

void check_rig(const std::string& name) {
  if (find_rig(name)) return;
  std::vector<std::string> known;
  for (const Rig& rig : rigs()) known.emplace_back(rig.name);
  throw SettingError("there is no rig '" + name + "'" + did_you_mean(name, known));
}

} // namespace

Shot shot_from(const CommandLine& line) {
  Shot shot;
  shot.command = line.command->name;
  shot.modes = default_modes(*line.command);
  if (line.command->options & figures) shot.frames = 32, shot.rig = "pass";
  apply_file_and_words(line, shot);
  check_rig(shot.rig);
  apply_assignments(line, shot);
  return shot;
}

json shot_json(const Shot& shot, uint32_t frames) {
  json object = {{"version", UNGHOST_VERSION}, {"command", shot.command},
                 {"scene", shot.scene},        {"rig", shot.rig},
                 {"seed", shot.seed},          {"frames", frames},
                 {"size", text_of(shot.size)}, {"settings", json::object()}};
  Settings settings = shot.settings;
  if (shot.command == "capture") {
    settings.taa = shot.modes.front().taa;
    object["mode"] = shot.modes.front().name;
    object["settings"] = settings_json(settings);
    return object;
  }
  object["crops"] = shot.crops;
  object["settings"] = settings_json(settings, SettingsPart::shared);
  for (const ModeRun& run : shot.modes) {
    settings.taa = run.taa;
    object["modes"].push_back(
        {{"name", run.name}, {"settings", settings_json(settings, SettingsPart::per_mode)}});
  }
  return object;
}

std::string text_of(PictureSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

} // namespace unghost
