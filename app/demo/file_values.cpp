#include "app/demo/file_values.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "app/rigs.h"
#include "renderer/screen.h"
#include "renderer/spelling.h"

namespace unghost {
namespace {

using nlohmann::json;

constexpr double widest = 1e6;           // radians and metres: beyond it nothing is seen
constexpr double askew = 1e-9;           // of a turn's length: doubles that were made one are nearer to it
constexpr size_t room = 3, quarters = 4; // numbers of a place and of a turn

json json_of(const glm::dvec3& v) { return json::array({v.x, v.y, v.z}); }

glm::dvec3 place_of(const json& value) {
  array_of(value, room, room);
  const auto number = [&](size_t i) { return number_of(value[i], -widest, widest); };
  return {number(0), number(1), number(2)};
}

glm::dquat turn_of(const json& value) {
  array_of(value, quarters, quarters);
  const auto number = [&](size_t i) { return number_of(value[i], -1, 1); };
  glm::dquat turn;
  turn.w = number(0), turn.x = number(1), turn.y = number(2), turn.z = number(3);
  if (std::abs(glm::dot(turn, turn) - 1) > askew) throw SettingError("it is a quaternion of length 1");
  return turn;
}

CameraOffset::Flown flown_of(const json& value) {
  if (object_of(value).size() != 2 || !value.contains("eye") || !value.contains("camera"))
    throw SettingError("it has 'eye' and 'camera'");
  CameraOffset::Flown flown{};
  within("eye", [&] { flown.eye = place_of(value["eye"]); });
  within("camera", [&] { flown.camera = turn_of(value["camera"]); });
  return flown;
}

void set_part(CameraOffset& camera, const std::string& name, const json& value) {
  if (name == "yaw")
    camera.yaw = number_of(value, -widest, widest);
  else if (name == "pitch")
    camera.pitch = number_of(value, -widest, widest);
  else if (name == "distance")
    camera.distance = number_of(value, nearest_camera, farthest_camera);
  else if (name == "pan")
    camera.pan = place_of(value);
  else if (name == "flown")
    camera.flown = flown_of(value);
  else
    throw SettingError("a camera has none");
}

} // namespace

double number_of(const json& value, double low, double high) {
  if (!value.is_number() || value < low || value > high)
    throw SettingError("it is a number from " + json(low).dump() + " to " + json(high).dump());
  return value.get<double>();
}

uint64_t count_of(const json& value, uint64_t most) {
  if (!value.is_number_unsigned() || value.get<uint64_t>() > most)
    throw SettingError("it is a whole number from 0" +
                       (most < UINT64_MAX ? " to " + std::to_string(most) : std::string{}));
  return value.get<uint64_t>();
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

std::string rig_of(const json& value) {
  const Rig* rig = find_rig(word_of(value));
  std::vector<std::string> known;
  for (const Rig& row : rigs()) known.emplace_back(row.name);
  if (rig == nullptr)
    throw SettingError("there is no rig '" + word_of(value) + "'" + did_you_mean(word_of(value), known));
  return std::string(rig->name);
}

Arrangement arrangement_of(const json& value) {
  const std::span<const Answer> all = answers<Arrangement>();
  const auto found = std::ranges::find(all, word_of(value), &Answer::name);
  if (found == all.end()) throw SettingError("there is no arrangement '" + word_of(value) + "'");
  return Arrangement(found->value);
}

json camera_json(const CameraOffset& camera) {
  const CameraOffset usual;
  json object = json::object();
  if (camera.yaw != usual.yaw) object["yaw"] = camera.yaw;
  if (camera.pitch != usual.pitch) object["pitch"] = camera.pitch;
  if (camera.distance != usual.distance) object["distance"] = camera.distance;
  if (camera.pan != usual.pan) object["pan"] = json_of(camera.pan);
  if (camera.flown) {
    const glm::dquat& turn = camera.flown->camera;
    object["flown"] = {{"eye", json_of(camera.flown->eye)}, {"camera", {turn.w, turn.x, turn.y, turn.z}}};
  }
  return object;
}

CameraOffset camera_of(const json& value) {
  CameraOffset camera;
  for (const auto& [name, part] : object_of(value).items())
    within(name, [&, &key = name, &content = part] { set_part(camera, key, content); });
  return camera;
}

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

void within(std::string_view where, const std::function<void()>& work) {
  try {
    work();
  } catch (const SettingError& error) {
    throw SettingError(std::string(where) + ": " + error.what());
  }
}

} // namespace unghost
