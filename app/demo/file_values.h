// What stands in the demo's files, as values: of whatever else, a sentence.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "app/demo/camera.h"
#include "renderer/settings.h"

namespace unghost {

/// The bound of what counts frames: more than half a year of them.
constexpr uint64_t latest_frame = 1'000'000'000;

// All of these throw SettingError.
double number_of(const nlohmann::json& value, double low, double high);
uint64_t count_of(const nlohmann::json& value, uint64_t most);
bool bool_of(const nlohmann::json& value);
const std::string& word_of(const nlohmann::json& value);
const nlohmann::json& array_of(const nlohmann::json& value, size_t least, size_t most);
const nlohmann::json& object_of(const nlohmann::json& value);
/// The name of one there is.
std::string rig_of(const nlohmann::json& value);
Arrangement arrangement_of(const nlohmann::json& value);
/// Of what camera_json made, to the bit.
CameraOffset camera_of(const nlohmann::json& value);
/// What differs from the rig's camera.
nlohmann::json camera_json(const CameraOffset& camera);

/// What `settings` have otherwise than `usual`.
nlohmann::json changed(const Settings& settings, const Settings& usual, SettingsPart part);
/// Sets what the object names, of that part and no other.
void apply_part(Settings& settings, const nlohmann::json& object, SettingsPart part);

/// Does it; a fault's sentence begins with where it was found.
void within(std::string_view where, const std::function<void()>& work);

} // namespace unghost
