#include "app/demo/demo_file.h"

#include <algorithm>
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "app/demo/file_values.h"
#include "app/failure.h"
#include "app/files.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr size_t file_limit = 1 << 20; // bytes; all settings of all modes are some 20,000
constexpr double least_scale = 0.5, longest_frame_ms = 1000;

/// What one key of the file holds.
struct Kept {
  std::string_view key;
  json (*get)(const DemoState&);
  void (*set)(DemoState&, const json&); // throws SettingError
};

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

json bookmarks_json(const DemoState& state) {
  json list = json::array();
  for (const Bookmark& mark : state.bookmarks)
    list.push_back({{"rig", mark.rig}, {"rig-frame", mark.rig_frame}, {"camera", camera_json(mark.camera)}});
  return list;
}

void set_part(Bookmark& mark, const std::string& key, const json& value) {
  if (key == "rig")
    mark.rig = rig_of(value);
  else if (key == "rig-frame")
    mark.rig_frame = count_of(value, latest_frame);
  else if (key == "camera")
    mark.camera = camera_of(value);
  else
    throw SettingError("a bookmark has none");
}

void set_bookmarks(DemoState& state, const json& value) {
  state.bookmarks.clear(), state.bookmark.reset();
  for (const json& entry : array_of(value, 0, most_bookmarks)) {
    Bookmark& mark = state.bookmarks.emplace_back();
    for (const auto& [key, part] : object_of(entry).items())
      within(key, [&, &name = key, &content = part] { set_part(mark, name, content); });
  }
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
      {"rig", [](const State& s) { return json(s.rig); },
       [](State& s, const json& value) { s.rig = rig_of(value); }},
      {"seed", [](const State& s) { return json(s.seed); },
       [](State& s, const json& value) { s.seed = count_of(value, UINT64_MAX); }},
      {"settings", shared_json, set_shared},
      {"modes", modes_json, set_modes},
      {"shown", [](const State& s) { return json(s.modes[s.mode].name); },
       [](State& s, const json& name) { s.mode = place_of_mode(s, word_of(name)); }},
      {"compared", compared_json, set_compared},
      {"arrangement", [](const State& s) { return json(spelling(s.arrangement)); },
       [](State& s, const json& value) { s.arrangement = arrangement_of(value); }},
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
      {"bookmarks", bookmarks_json, set_bookmarks},
  };
  return rows;
}

void set_kept(DemoState& state, const std::string& key, const json& value) {
  const auto row = std::ranges::find(kept(), key, &Kept::key);
  if (row == kept().end()) throw SettingError("there is no '" + key + "'");
  within(key, [&] { row->set(state, value); });
}

void check_seen_once(const DemoState& state) {
  std::vector<size_t> places = state.compared;
  places.push_back(state.mode);
  for (const size_t place : places)
    if (std::ranges::count(places, place) > 1)
      throw SettingError("compared: " + state.modes[place].name + " is seen twice");
}

/// A slip in a file that a person edited costs no bookmark: what is saved on leaving does not go over it.
std::string set_aside(const fs::path& file) {
  const fs::path aside = free_name(file.string() + ".refused", "");
  std::error_code fault;
  fs::rename(file, aside, fault);
  return fault ? "" : ", and it is kept as " + aside.filename().string();
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
  if (!object.contains("compared")) // what is not named makes room, as it does for a key
    std::ranges::replace(applied.compared, applied.mode, state.mode);
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
  if (!loaded.complaint.empty()) loaded.complaint += "; the defaults are taken" + set_aside(file);
  return loaded;
}

void save_demo(const DemoState& state, const fs::path& file) {
  if (file.empty()) return;
  make_folder(file.parent_path());
  write_file(file, bytes_of(demo_json(state).dump(2) + "\n"));
}

} // namespace unghost
