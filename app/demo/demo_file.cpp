#include "app/demo/demo_file.h"

#include <algorithm>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "app/files.h"
#include "app/rigs.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr size_t file_limit = 1 << 20; // bytes; all settings of all modes are some 20,000
constexpr size_t most_compared = 3;
constexpr double least_scale = 0.5, longest_frame_ms = 1000;

/// What one key of the file holds.
struct Kept {
  std::string_view key;
  json (*get)(const DemoState&);
  void (*set)(DemoState&, const json&); // throws SettingError
};

double number_of(const json& value, double low, double high) {
  if (!value.is_number() || value < low || value > high)
    throw SettingError("it is a number from " + json(low).dump() + " to " + json(high).dump());
  return value.get<double>();
}

bool bool_of(const json& value) {
  if (!value.is_boolean()) throw SettingError("it is true or false");
  return value.get<bool>();
}

const std::string& word_of(const json& value) {
  if (!value.is_string()) throw SettingError("it is a word");
  return value.get_ref<const std::string&>();
}

const json& array_of(const json& value, size_t least, size_t most) {
  if (!value.is_array() || value.size() < least || value.size() > most)
    throw SettingError("it is a list of " + std::to_string(least) +
                       (most > least ? " to " + std::to_string(most) : ""));
  return value;
}

const json& object_of(const json& value) {
  if (!value.is_object()) throw SettingError("it is an object");
  return value;
}

/// What `settings` have otherwise than `usual`.
json changed(const Settings& settings, const Settings& usual, SettingsPart part) {
  json object = settings_json(settings, part);
  const json unchanged = settings_json(usual, part);
  for (const auto& [name, value] : unchanged.items())
    if (object.at(name) == value) object.erase(name);
  return object;
}

void apply_part(Settings& settings, const json& object, SettingsPart part) {
  for (const auto& [name, value] : object_of(object).items())
    if (find_setting(name).per_mode != (part == SettingsPart::per_mode))
      throw SettingError(name +
                         (part == SettingsPart::per_mode ? " is shared by all modes" : " is a mode's own"));
  apply_settings_json(settings, object);
}

json shared_json(const DemoState& state) { return changed(state.settings, {}, SettingsPart::shared); }

void set_shared(DemoState& state, const json& object) {
  Settings settings;
  apply_part(settings, object, SettingsPart::shared);
  state.settings = settings;
}

json modes_json(const DemoState& state) {
  json object = json::object();
  for (size_t i = 0; i < state.modes.size(); ++i) {
    const std::string& name = state.modes[i].name;
    json own = changed(settings_of(state, i), settings_for_mode(name), SettingsPart::per_mode);
    if (!own.empty()) object[name] = std::move(own);
  }
  return object;
}

// One that the file does not name is as its row has it.
void set_modes(DemoState& state, const json& object) {
  for (ModeRun& run : state.modes) run.taa = settings_for_mode(run.name).taa;
  for (const auto& [name, own] : object_of(object).items()) {
    ModeRun& run = state.modes[place_of_mode(state, name)];
    Settings settings = settings_for_mode(name);
    apply_part(settings, own, SettingsPart::per_mode);
    if (const auto why = refusal(settings)) throw SettingError(name + ": " + *why);
    run.taa = settings.taa;
  }
}

void set_rig(DemoState& state, const json& value) {
  const Rig* rig = find_rig(word_of(value));
  std::vector<std::string> known;
  for (const Rig& row : rigs()) known.emplace_back(row.name);
  if (rig == nullptr)
    throw SettingError("there is no rig '" + word_of(value) + "'" + did_you_mean(word_of(value), known));
  state.rig = rig->name;
}

void set_seed(DemoState& state, const json& value) {
  if (!value.is_number_unsigned()) throw SettingError("it is a whole number from 0");
  state.seed = value.get<uint64_t>();
}

json compared_json(const DemoState& state) {
  json names = json::array();
  for (const size_t mode : state.compared) names.push_back(state.modes[mode].name);
  return names;
}

void set_compared(DemoState& state, const json& value) {
  state.compared.clear();
  for (const json& name : array_of(value, 1, most_compared))
    state.compared.push_back(place_of_mode(state, word_of(name)));
}

void set_arrangement(DemoState& state, const json& value) {
  const std::span<const Answer> all = answers<Arrangement>();
  const auto found = std::ranges::find(all, word_of(value), &Answer::name);
  if (found == all.end()) throw SettingError("there is no arrangement '" + word_of(value) + "'");
  state.arrangement = Arrangement(found->value);
}

void set_magnified(DemoState& state, const json& value) {
  array_of(value, 2, 2);
  state.magnifier.centre = {number_of(value[0], 0, 1), number_of(value[1], 0, 1)};
}

void set_frame_ms(DemoState& state, const json& value) {
  state.frame_ms.reset();
  if (!value.is_null()) state.frame_ms = number_of(value, 1, longest_frame_ms);
}

template <auto... path> Kept kept_bool(std::string_view key) {
  return {key, [](const DemoState& s) { return json((s.*....*path)); },
          [](DemoState& s, const json& value) { (s.*....*path) = bool_of(value); }};
}

std::span<const Kept> kept() {
  using State = DemoState;
  static const Kept rows[] = {
      {"rig", [](const State& s) { return json(s.rig); }, set_rig},
      {"seed", [](const State& s) { return json(s.seed); }, set_seed},
      {"settings", shared_json, set_shared},
      {"modes", modes_json, set_modes},
      {"shown", [](const State& s) { return json(s.modes[s.mode].name); },
       [](State& s, const json& name) { s.mode = place_of_mode(s, word_of(name)); }},
      {"compared", compared_json, set_compared},
      {"arrangement", [](const State& s) { return json(spelling(s.arrangement)); }, set_arrangement},
      {"split", [](const State& s) { return json(s.split); },
       [](State& s, const json& value) { s.split = number_of(value, 0, 1); }},
      kept_bool<&State::magnifier, &Magnifier::shown>("magnifier"),
      {"magnified",
       [](const State& s) {
         return json({s.magnifier.centre.x, s.magnifier.centre.y});
       },
       set_magnified},
      kept_bool<&State::magnifier_follows>("magnifier-follows"),
      kept_bool<&State::panel>("panel"),
      {"render-scale", [](const State& s) { return json(s.render_scale); },
       [](State& s, const json& value) { s.render_scale = number_of(value, least_scale, 1); }},
      {"frame-ms", [](const State& s) { return s.frame_ms ? json(*s.frame_ms) : json(); }, set_frame_ms},
  };
  return rows;
}

void set_kept(DemoState& state, const std::string& key, const json& value) {
  const auto row = std::ranges::find(kept(), key, &Kept::key);
  if (row == kept().end()) throw SettingError("there is no '" + key + "'");
  try {
    row->set(state, value);
  } catch (const SettingError& error) {
    throw SettingError(key + ": " + error.what());
  }
}

void check_seen_once(const DemoState& state) {
  std::vector<size_t> places = state.compared;
  places.push_back(state.mode);
  for (const size_t place : places)
    if (std::ranges::count(places, place) > 1)
      throw SettingError("compared: " + state.modes[place].name + " is seen twice");
}

} // namespace

json demo_json(const DemoState& state) {
  json object;
  for (const Kept& row : kept()) object[std::string(row.key)] = row.get(state);
  return object;
}

void apply_demo_json(DemoState& state, const json& object) {
  DemoState applied = state;
  for (const auto& [key, value] : object_of(object).items()) set_kept(applied, key, value);
  check_seen_once(applied);
  state = std::move(applied);
}

fs::path config_file() {
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  const fs::path within = fs::path("unghost") / "config.json";
  if (config != nullptr && *config == '/') return config / within; // a relative one is to be ignored (XDG)
  if (home != nullptr && *home == '/') return fs::path(home) / ".config" / within;
  return {};
}

LoadedDemo load_demo(const fs::path& file) {
  LoadedDemo loaded{.state = default_demo_state()};
  std::error_code ignored;
  if (fs::symlink_status(file, ignored).type() == fs::file_type::not_found) return loaded;
  try {
    apply_demo_json(loaded.state, json::parse(read_file(file, file_limit)));
  } catch (const Failure& failure) {
    loaded.complaint = failure.what();
  } catch (const SettingError& error) {
    loaded.complaint = file.string() + ": " + error.what();
  } catch (const json::exception&) {
    loaded.complaint = file.string() + " is no JSON";
  }
  if (!loaded.complaint.empty()) loaded.complaint += "; the defaults are taken";
  return loaded;
}

void save_demo(const DemoState& state, const fs::path& file) {
  if (file.empty()) return;
  make_folder(file.parent_path());
  write_file(file, bytes_of(demo_json(state).dump(2) + "\n"));
}

} // namespace unghost
