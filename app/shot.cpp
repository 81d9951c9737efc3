#include "app/shot.h"

#include <algorithm>
#include <new>

#include <nlohmann/json.hpp>

#include "app/assignments.h"
#include "app/commands.h"
#include "app/failure.h"
#include "app/files.h"
#include "app/png_file.h"
#include "app/replayed_shot.h"
#include "app/rigs.h"
#include "app/version.h"
#include "renderer/mode_names.h"

namespace unghost {
namespace {

using nlohmann::json;

constexpr size_t settings_file_limit = 256 << 20;
constexpr std::string_view all_modes = "all"; // a word of --modes
constexpr uint32_t explained_frames = 8;      // a history, and a whole cycle of most jitters
// Aliased, the ghost itself, the article's way without it, and ours.
const std::vector<std::string> default_comparison = {"off", "blend", "grand-tour", "unghost"};

std::vector<ModeRun> default_modes(const CommandRow& command) {
  std::vector<ModeRun> runs;
  if (command.options & one_mode) return {mode_run(std::string(default_taa_mode))};
  if (command.options & (figures | timed))
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

// Names of modes become names of files, and keys.
void check_name(const std::string& name, const std::vector<ModeRun>& others) {
  const bool plain = !name.empty() && name.front() != '.' &&
                     name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-:=+.") == std::string::npos;
  if (!plain || name == "reference") throw SettingError("'" + name + "' is no name of a mode");
  if (std::ranges::count(others, name, &ModeRun::name) > 0) throw SettingError("it has " + name + " twice");
}

// Those that a picture shows: one of its own, or the columns of a comparison.
std::vector<ModeRun> modes_of(const json& file, const Settings& settings) {
  std::vector<ModeRun> runs;
  if (file.contains("mode"))
    runs.push_back({.name = file.at("mode").get<std::string>(), .taa = settings.taa});
  for (const json& entry : file.value("modes", json::array())) {
    Settings own;
    apply_settings_json(own, entry.at("settings"));
    check_name(entry.at("name").get<std::string>(), runs);
    runs.push_back({.name = entry.at("name").get<std::string>(), .taa = own.taa});
  }
  return runs;
}

// What a picture carries, but for its modes.
void apply_shot(const json& file, Shot& shot) {
  if (file.contains("replay"))
    throw SettingError("it is of a path that was replayed: --replay with that file draws it again");
  apply_settings_json(shot.settings, file.at("settings"));
  shot.scene = file.value("scene", shot.scene);
  shot.rig = file.value("rig", shot.rig);
  shot.seed = file.value("seed", shot.seed);
  shot.frames = file.value("frames", shot.frames);
  shot.crops = file.value("crops", shot.crops);
  if (shot.frames - 1 >= most_frames)
    throw SettingError("frames are from 1 to " + std::to_string(most_frames));
  if (file.contains("size")) shot.size = picture_size(file.at("size").get<std::string>());
}

void apply_words(const CommandLine& line, Shot& shot) {
  if (line.scene) shot.scene = *line.scene;
  if (line.rig) shot.rig = *line.rig;
  if (line.seed) shot.seed = *line.seed;
  if (line.size) shot.size = *line.size;
  if (line.frames) shot.frames = *line.frames;
  if (line.crops) shot.crops = *line.crops;
}

// A picture of one mode is no comparison, and which of several a capture means is not guessed.
void check_choice(const CommandLine& line, const std::vector<ModeRun>& of_file, bool comparison) {
  std::string shown;
  for (const ModeRun& run : of_file) shown += (shown.empty() ? "" : ", ") + run.name;
  const std::string file = line.settings.string();
  if (line.command->options & many_modes) {
    if (line.modes.empty() && !of_file.empty() && !comparison)
      throw SettingError(file + " shows one mode, " + shown +
                         ": --modes says which to set beside one another");
  } else if (of_file.size() > 1) {
    if (!line.mode) throw SettingError(file + " shows " + shown + ": --mode picks one of them");
    if (std::ranges::count(of_file, *line.mode, &ModeRun::name) == 0)
      throw SettingError(file + " shows " + shown + ", and no '" + *line.mode + "'");
  }
}

// A mode that the words name is as the file has it, where it does.
void choose_modes(const CommandLine& line, const std::vector<ModeRun>& of_file, Shot& shot) {
  const std::vector<std::string> names = named_modes(line);
  if (names.empty() && !of_file.empty()) shot.modes = of_file;
  if (names.empty()) return;
  shot.modes.clear();
  for (const std::string& name : names) {
    const auto found = std::ranges::find(of_file, name, &ModeRun::name);
    shot.modes.push_back(found == of_file.end() ? mode_run(name) : *found);
  }
}

std::vector<Assignment> assignments_in(const json& file) {
  std::vector<Assignment> assignments;
  Settings settings;
  apply_settings_json(settings, file);
  for (const auto& [name, value] : file.items())
    assignments.push_back({.text = name + "=" + find_setting(name).get(settings), .of_file = true});
  return assignments;
}

/// Fills `shot` from the settings file and the words, which win over it. Returns the settings that remain to
/// be applied: those of a file of nothing but settings.
std::vector<Assignment> apply_file_and_words(const CommandLine& line, Shot& shot) {
  std::vector<Assignment> plain;
  std::vector<ModeRun> of_file;
  bool comparison = false;
  if (!line.settings.empty()) {
    const json file = parse_settings_file(line.settings);
    try {
      if (file.contains("settings")) {
        apply_shot(file, shot);
        of_file = modes_of(file, shot.settings);
        comparison = file.contains("modes");
      } else {
        plain = assignments_in(file);
      }
    } catch (const std::bad_alloc&) {
      throw;                                // is no fault of the file
    } catch (const std::exception& error) { // a setting, a size or a type in it is wrong
      throw Failure(Exit::input_refused, line.settings.string() + ": " + error.what());
    }
  }
  apply_words(line, shot);
  check_choice(line, of_file, comparison);
  choose_modes(line, of_file, shot);
  return plain;
}

[[noreturn]] void refuse(const CommandLine& line, bool of_file, const std::string& sentence) {
  if (of_file) throw Failure(Exit::input_refused, line.settings.string() + ": " + sentence);
  throw SettingError(sentence);
}

// An assignment reaches the modes that it has an effect on, and is refused where it has one on none.
void set_asked(const CommandLine& line, const std::vector<Assignment>& assignments, Shot& shot) {
  const std::vector<Assignment> unused = apply_assignments(assignments, shot.settings, shot.modes);
  if (!unused.empty()) refuse(line, unused.front().of_file, without_effect(unused.front(), shot.modes));
  if (const auto why = refusal(shot.settings, shot.modes))
    refuse(line, !line.settings.empty() && line.assignments.empty(), *why);
}

constexpr const char* measured_jitter =
    "all modes that jitter and keep their result are measured with the same ten points of R2, scaled as each "
    "has it";

// Errors are taken of modes that jitter alike.
void refuse_jitter(const CommandLine& line, const std::vector<Assignment>& assignments,
                   const std::vector<ModeRun>& modes) {
  for (const Assignment& each : assignments)
    if (each.row().name == "jitter")
      refuse(line, each.of_file, each.text + " has no effect: " + measured_jitter);
  for (const ModeRun& run : modes)
    if (mode_says(run.name, "jitter")) throw SettingError(run.name + ": " + measured_jitter);
}

// Run times compare the modes on the same geometry, which a jitter would move.
void drop_jitter(const CommandLine& line, const std::vector<Assignment>& assignments, Shot& shot) {
  for (const Assignment& each : assignments)
    if (each.row().name.starts_with("jitter"))
      refuse(line, each.of_file,
             each.text + " has no effect: " + shot.command +
                 " draws all modes without jitter, so that they share their geometry");
  for (const ModeRun& run : shot.modes)
    if (mode_says(run.name, "jitter") || mode_says(run.name, "jitter-scale") ||
        mode_says(run.name, "jitter-moving"))
      throw SettingError(run.name + ": " + shot.command +
                         " draws all modes without jitter, so that they share their geometry");
  for (ModeRun& run : shot.modes) run.taa.policy.jitter = Jitter::none;
}

void check_rig(const std::string& name) {
  if (find_rig(name)) return;
  std::vector<std::string> known;
  for (const Rig& rig : rigs()) known.emplace_back(rig.name);
  throw SettingError("there is no rig '" + name + "'" + did_you_mean(name, known));
}

} // namespace

std::vector<std::string> named_modes(const CommandLine& line) {
  if (line.mode) return {*line.mode};
  std::vector<std::string> names;
  for (const std::string& name : line.modes)
    if (name == all_modes)
      for (const TaaMode& row : taa_modes()) names.emplace_back(row.name);
    else
      names.push_back(name);
  for (const std::string& name : names)
    if (std::ranges::count(names, name) > 1) throw SettingError("--modes names " + name + " more than once");
  return names;
}

Shot shot_from(const CommandLine& line) {
  if (!line.replay.empty()) return replayed_shot(line);
  if (line.scene && !is_utf8(*line.scene)) throw WrongWords("the scene's name is not UTF-8");
  Shot shot;
  shot.command = line.command->name;
  shot.modes = default_modes(*line.command);
  if (line.command->options & figures) shot.rig = "pass";
  if (line.command->options & anatomy) shot.frames = explained_frames;
  std::vector<Assignment> assignments = apply_file_and_words(line, shot);
  check_rig(shot.rig);
  for (const std::string& text : line.assignments) {
    apply_setting(shot.settings, text); // refuses what is no assignment
    assignments.push_back({.text = text});
  }
  if (line.command->options & timed) drop_jitter(line, assignments, shot);
  if (line.command->options & figures) refuse_jitter(line, assignments, shot.modes);
  set_asked(line, assignments, shot);
  return shot;
}

json shot_json(const Shot& shot, uint32_t frames) {
  json object = {{"version", UNGHOST_VERSION}, {"command", shot.command},
                 {"scene", shot.scene},        {"rig", shot.rig},
                 {"seed", shot.seed},          {"frames", frames},
                 {"size", text_of(shot.size)}, {"settings", json::object()}};
  if (shot.replay) object["replay"] = shot.replay->file;
  if (shot.replay && !shot.replay->assignments.empty()) object["set"] = shot.replay->assignments;
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

bool is_utf8(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)) == json(text);
}

std::string text_of(PictureSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

} // namespace unghost
