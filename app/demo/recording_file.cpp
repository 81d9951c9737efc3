#include "app/demo/recording_file.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/demo/file_values.h"
#include "app/failure.h"
#include "app/files.h"
#include "app/shot.h"
#include "app/version.h"
#include "renderer/spelling.h"

namespace unghost {
namespace {

using nlohmann::json;

constexpr const char* format_name = "unghost path";
constexpr uint64_t format_version = 1;
constexpr size_t most_shown = most_compared + 1;
// What this program writes takes more bytes for each.
constexpr size_t most_commas = recording_limit / 4, most_brackets = recording_limit / 16;
constexpr size_t room_for_a_frame = 64 << 10; // bytes; all settings of all modes are some 20,000

uint64_t after(const std::optional<uint64_t>& count) { return count ? *count + 1 : 0; }

json names_of(const Look& look) {
  json names = json::array();
  for (const size_t mode : look.shown) names.push_back(look.modes[mode].name);
  return names;
}

Settings settings_of(const Look& look, size_t mode) {
  Settings settings = look.settings;
  settings.taa = look.modes[mode].taa;
  return settings;
}

void write_moment(json& frame, const Moment& moment, const std::optional<Moment>& before) {
  const Moment last = before.value_or(Moment{});
  const auto count = [&](auto member) { return before ? std::optional((*before).*member) : std::nullopt; };
  if (moment.rig != last.rig) frame["rig"] = moment.rig;
  if (moment.rig_frame != after(count(&Moment::rig_frame))) frame["rig-frame"] = moment.rig_frame;
  if (moment.camera != last.camera) frame["camera"] = camera_json(moment.camera);
  if (moment.index != after(count(&Moment::index))) frame["index"] = moment.index;
  if (!before || moment.size != last.size) frame["size"] = text_of(moment.size);
  if (moment.cut) frame["cut"] = true;
}

void write_look(json& frame, const Look& look, const Look& last) {
  if (look == last) return;
  if (json own = changed(look.settings, last.settings, SettingsPart::shared); !own.empty())
    frame["settings"] = std::move(own);
  for (size_t mode = 0; mode < look.modes.size(); ++mode)
    if (look.modes[mode] != last.modes[mode])
      frame["modes"][look.modes[mode].name] =
          changed(settings_of(look, mode), settings_of(last, mode), SettingsPart::per_mode);
  if (look.shown != last.shown) frame["shown"] = names_of(look);
  if (look.arrangement != last.arrangement) frame["arrangement"] = spelling(look.arrangement);
}

/// What is read so far: a frame begins as the one before it was.
struct Reading {
  Moment moment;
  Look look = usual_look();
  bool other_look = true;
};

PictureSize size_of(const json& value) {
  try {
    return picture_size(word_of(value));
  } catch (const WrongWords& error) {
    throw SettingError(error.what());
  }
}

void set_modes(Look& look, const json& value) {
  const DemoState rows = default_demo_state();
  for (const auto& [name, own] : object_of(value).items()) {
    const size_t mode = place_of_mode(rows, name);
    within(name, [&, &object = own] {
      Settings settings = settings_of(look, mode);
      apply_part(settings, object, SettingsPart::per_mode);
      if (const auto why = refusal(settings)) throw SettingError(*why);
      look.modes[mode].taa = settings.taa;
    });
  }
}

void set_shown(Look& look, const json& value) {
  const DemoState rows = default_demo_state();
  look.shown.clear();
  for (const json& name : array_of(value, 1, most_shown)) {
    const size_t mode = place_of_mode(rows, word_of(name));
    if (std::ranges::count(look.shown, mode) > 0) throw SettingError("it has " + word_of(name) + " twice");
    look.shown.push_back(mode);
  }
}

/// What one key of a frame holds.
struct Recorded {
  std::string_view key;
  bool of_look = false;
  void (*set)(Reading&, const json&) = nullptr; // throws SettingError
};

constexpr Recorded recorded[] = {
    {"rig", false, [](Reading& r, const json& value) { r.moment.rig = rig_of(value); }},
    {"rig-frame", false, [](Reading& r, const json& v) { r.moment.rig_frame = count_of(v, latest_frame); }},
    {"camera", false, [](Reading& r, const json& value) { r.moment.camera = camera_of(value); }},
    {"index", false, [](Reading& r, const json& value) { r.moment.index = count_of(value, latest_frame); }},
    {"size", false, [](Reading& r, const json& value) { r.moment.size = size_of(value); }},
    {"cut", false, [](Reading& r, const json& value) { r.moment.cut = bool_of(value); }},
    {"settings", true,
     [](Reading& r, const json& value) { apply_part(r.look.settings, value, SettingsPart::shared); }},
    {"modes", true, [](Reading& r, const json& value) { set_modes(r.look, value); }},
    {"shown", true, [](Reading& r, const json& value) { set_shown(r.look, value); }},
    {"arrangement", true, [](Reading& r, const json& value) { r.look.arrangement = arrangement_of(value); }},
};

/// Fewer or more could not be shown again as they were.
void check_seen(const Look& look) {
  DemoState state = default_demo_state();
  take_look(state, look);
  if (modes_seen(state) != look.shown)
    throw SettingError("shown: '" + std::string(spelling(look.arrangement)) + "' does not show " +
                       std::to_string(look.shown.size()) + " modes");
}

void read_frame(Reading& reading, const json& frame) {
  reading.other_look = false;
  for (const auto& [key, value] : object_of(frame).items()) {
    const auto row = std::ranges::find(recorded, key, &Recorded::key);
    if (row == std::end(recorded)) throw SettingError("there is no '" + key + "'");
    within(key, [&, &content = value] { row->set(reading, content); });
    reading.other_look |= row->of_look;
  }
  if (reading.other_look) check_seen(reading.look);
}

void add_frame(Recording& recording, Reading& reading, const json& frame) {
  if (!recording.frames.empty()) ++reading.moment.rig_frame, ++reading.moment.index;
  reading.moment.cut = false;
  read_frame(reading, frame);
  if (recording.frames.empty() && !reading.moment.cut) throw SettingError("cut: the first frame is one");
  if (recording.frames.empty() && !frame.contains("size"))
    throw SettingError("size: the first frame has one");
  if (recording.looks.empty() || reading.other_look) recording.looks.push_back(reading.look);
  if (!same_stage(reading.look.settings.stage, recording.looks.front().settings.stage))
    throw SettingError("settings: the stage is another than the first frame's");
  recording.frames.push_back({.moment = reading.moment, .look = recording.looks.size() - 1});
}

void read_head(Recording& recording, const json& object) {
  constexpr std::string_view keys[] = {"format", "version", "program", "scene", "seed", "frames"};
  for (const auto& [key, value] : object.items())
    if (std::ranges::find(keys, key) == std::end(keys)) throw SettingError("there is no '" + key + "'");
  for (const std::string_view key : keys)
    if (!object.contains(key)) throw SettingError("it has no '" + std::string(key) + "'");
  if (object["version"] != format_version)
    throw SettingError("version: this program reads " + std::to_string(format_version));
  within("program", [&] { word_of(object["program"]); });
  within("scene", [&] { recording.scene = word_of(object["scene"]); });
  within("seed", [&] { recording.seed = count_of(object["seed"], UINT64_MAX); });
}

/// Small values of a large file would take many times its size.
json parsed(const std::string& text) {
  size_t commas = 0, brackets = 0;
  for (const char c : text) commas += c == ',', brackets += c == '{' || c == '[';
  if (commas > most_commas || brackets > most_brackets)
    throw SettingError("it holds more than a recording can");
  return json::parse(text);
}

} // namespace

Recorder::Recorder(const std::string& scene, uint64_t seed) : look_(usual_look()) {
  json head = {{"format", format_name},
               {"version", format_version},
               {"program", UNGHOST_VERSION},
               {"scene", scene},
               {"seed", seed}};
  head_ = head.dump();
  head_.pop_back(); // which is open until the frames are in it
}

std::string Recorder::why_not(const Look& look) const {
  if (frames_ == 0) return {};
  if (!same_stage(look.settings.stage, look_.settings.stage)) return "another stage";
  const bool full = frames_ == most_recorded_frames || lines_.size() > recording_limit - room_for_a_frame;
  return full ? "it is as long as it can be" : "";
}

void Recorder::add(const Moment& moment, const Look& look) {
  json frame = json::object();
  write_moment(frame, moment, before_);
  write_look(frame, look, look_);
  lines_ += (frames_++ == 0 ? "\n" : ",\n") + frame.dump();
  before_ = moment;
  look_ = look;
}

std::string Recorder::text() const { return head_ + ",\"frames\":[" + lines_ + "\n]}\n"; }

Recording recording_from_text(const std::string& text) {
  const json object = parsed(text);
  if (!object.is_object() || object.value("format", json()) != format_name)
    throw SettingError("it is no recording: its format is not '" + std::string(format_name) + "'");
  Recording recording;
  read_head(recording, object);
  within("frames", [&] { array_of(object["frames"], 1, most_recorded_frames); });
  Reading reading;
  for (const json& frame : object["frames"])
    within("frame " + std::to_string(recording.frames.size()), [&] { add_frame(recording, reading, frame); });
  return recording;
}

Recording load_recording(const std::filesystem::path& file) {
  const std::vector<uint8_t> bytes = read_file(file, recording_limit);
  const auto refuse = [&](const std::string& why) {
    throw Failure(Exit::input_refused, file.string() + why);
  };
  try {
    return recording_from_text({bytes.begin(), bytes.end()});
  } catch (const SettingError& error) {
    refuse(std::string(": ") + error.what());
  } catch (const json::exception&) {
    refuse(" is no JSON");
  }
  return {};
}

} // namespace unghost
