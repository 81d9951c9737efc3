// `unghost modes | rigs | views | settings | info`.
#include <cmath>
#include <cstdlib>
#include <functional>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/demo/actions.h"
#include "app/failure.h"
#include "app/paths.h"
#include "app/rigs.h"
#include "app/table.h"
#include "app/version.h"
#include "renderer/gpu/device.h"
#include "renderer/settings.h"

namespace unghost {
namespace {

using nlohmann::json;

void print(const CommandLine& line, Console& console, const json& object, const Table& table) {
  if (line.json)
    console.out << object.dump(2) << "\n";
  else
    console.out << table.text();
}

std::string range_of(const Setting& row) {
  if (row.kind == SettingKind::number)
    return fixed(row.low, row.low == std::round(row.low) ? 0 : 2) + " to " + fixed(row.high, 0) +
           (row.unit.empty() ? "" : " " + std::string(row.unit));
  std::string choices;
  for (const Answer& answer : row.answers) choices += (choices.empty() ? "" : " ") + answer.name;
  return choices;
}

json setting_json(const Setting& row) {
  json object = {{"name", row.name}, {"summary", row.summary}, {"source", row.source}, {"unit", row.unit}};
  object["default"] = settings_json(Settings{})[std::string(row.name)];
  if (row.kind == SettingKind::number) {
    object["low"] = row.low, object["high"] = row.high;
    return object;
  }
  for (const Answer& answer : row.answers) object["choices"].push_back(answer.name);
  if (row.kind == SettingKind::flags) object["several"] = true; // with commas between them; or the default
  return object;
}

// Those of the loader, the drivers and ours that change what a run does.
json environment() {
  json object = json::object();
  for (const char* name : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_ADD_DRIVER_FILES", "VK_LAYER_PATH",
                           "VK_INSTANCE_LAYERS", "VK_LOADER_LAYERS_ENABLE", "MESA_SHADER_CACHE_DIR",
                           "MESA_SHADER_CACHE_DISABLE", "MESA_VK_DEVICE_SELECT", "LP_NUM_THREADS",
                           "LP_NATIVE_VECTOR_WIDTH", "UNGHOST_DEVICE", "UNGHOST_VALIDATE", "NO_COLOR"})
    if (const char* value = std::getenv(name)) object[name] = value;
  return object;
}

json device_json(const DeviceFacts& facts) {
  return {{"name", facts.name},         {"driver", facts.driver}, {"api_version", facts.api_version},
          {"software", facts.software}, {"usable", facts.usable}, {"missing", facts.missing}};
}

std::string fate_of(const DeviceFacts& facts) {
  if (!facts.usable) return "not usable: " + facts.missing;
  return facts.software ? "usable, software: its times are not a GPU's" : "usable";
}

// No default: a view without a sentence is a warning.
std::string_view summary_of(View view) {
  switch (view) {
  case View::colour:
    return "The finished picture.";
  case View::albedo:
    return "The base colour of each surface, without light.";
  case View::normal:
    return "The direction that each surface faces: red x, green y, blue z.";
  case View::depth:
    return "Distance on a logarithmic scale: white near, black far.";
  case View::motion:
    return "Where each pixel moves (hue and arrows) and how far (strength).";
  case View::tag:
    return "Each vehicle tag in a colour of its own, the untagged in grey.";
  case View::shadow:
    return "How much of the sun each pixel sees: white all of it.";
  case View::weight:
    return "The weight of the current frame: white where no history is used.";
  case View::rectified:
    return "Red where the history was bounded by its neighbourhood.";
  case View::tag_rejected:
    return "Red where the history was given up because the tag differs from last frame's.";
  case View::near_moving:
    return "Red where the history was faded because the pixel is near, moving and untagged.";
  case View::rejected:
    return "Where the history was given up, or lit anew: off-screen red, tag green, near and moving violet, "
           "velocity yellow, length of motion cyan, speed pink, depth lime, object blue, moved object "
           "orange, visibility (lit anew, or bounded where there is too much light to tell) turquoise; of "
           "several the last.";
  case View::history:
    return "The history as it was mixed with the current frame.";
  case View::age:
    return "How many frames a pixel holds: black none, white 63 or more, on a logarithmic scale; modes that "
           "know causes count to 16.";
  case View::volume:
    return "How large the colour box of the 3x3 neighbourhood is: white lets anything pass.";
  case View::light_channel:
    return "How much light arrives, as modes that know causes are told; orange where it may be another than "
           "last frame's, beside on what moves.";
  case View::pixel_class:
    return "What modes that know causes take a pixel for: plain grey, glossy blue where anything moves or "
           "light changes, mixed yellow, moving green, mixed and moving red.";
  }
  return {};
}

} // namespace

void list_modes(const CommandLine& line, Console& console) {
  json modes = json::array();
  Table table{{"mode", "summary", "source"}};
  for (const TaaMode& mode : taa_modes()) {
    const std::string name(mode.name);
    modes.push_back({{"name", name},
                     {"summary", mode.summary},
                     {"source", mode.source},
                     {"settings", settings_json(settings_for_mode(name), SettingsPart::per_mode)}});
    table.add({name, std::string(mode.summary), std::string(mode.source)});
  }
  print(line, console, {{"modes", modes}}, table);
}

void list_rigs(const CommandLine& line, Console& console) {
  json list = json::array();
  Table table{{"rig", "summary"}};
  for (const Rig& rig : rigs()) {
    list.push_back({{"name", rig.name}, {"summary", rig.summary}});
    table.add({std::string(rig.name), std::string(rig.summary)});
  }
  print(line, console, {{"rigs", list}}, table);
}

void list_keys(const CommandLine& line, Console& console) {
  json list = json::array();
  Table table{{"key", "gamepad", "what it does"}};
  for (const Action& action : actions()) {
    list.push_back({{"key", key_text(action)}, {"gamepad", button_text(action)}, {"what", action.what}});
    table.add({key_text(action), std::string(button_text(action)), action.what});
  }
  print(line, console, {{"keys", list}}, table);
}

void list_views(const CommandLine& line, Console& console) {
  json list = json::array();
  Table table{{"view", "summary"}};
  for (const Answer& view : answers<View>()) {
    const std::string summary(summary_of(View(view.value)));
    list.push_back({{"name", view.name}, {"summary", summary}});
    table.add({view.name, summary});
  }
  print(line, console, {{"views", list}}, table);
}

void list_settings(const CommandLine& line, Console& console) {
  json list = json::array();
  Table table{{"setting", "default", "values", "summary"}};
  for (const Setting& row : settings_table()) {
    list.push_back(setting_json(row));
    table.add({std::string(row.name), row.get(Settings{}), range_of(row), std::string(row.summary)});
  }
  print(line, console, {{"settings", list}}, table);
}

void info(const CommandLine& line, Console& console) {
  json object = {{"version", UNGHOST_VERSION}, {"environment", environment()}, {"devices", json::array()}};
  Table table{{"what", "value", "remark"}};
  table.add({"version", UNGHOST_VERSION, ""});
  const DataFolders folders = find_data_folders();
  object["assets"] = folders.assets.string(), object["shaders"] = folders.shaders.string();
  table.add({"assets", folders.assets.string(), ""});
  table.add({"shaders", folders.shaders.string(), ""});
  for (const auto& [name, value] : object["environment"].items())
    table.add({name, value.get<std::string>(), ""});
  const std::vector<DeviceFacts> devices = list_devices();
  for (size_t i = 0; i < devices.size(); ++i) {
    object["devices"].push_back(device_json(devices[i]));
    table.add(
        {"device " + std::to_string(i), devices[i].name + ", " + devices[i].driver, fate_of(devices[i])});
  }
  print(line, console, object, table);
}

} // namespace unghost
