#include "renderer/settings.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include <nlohmann/json.hpp>

#include "renderer/mode_names.h"

namespace unghost {
namespace {

constexpr std::string_view empty_flags = "nothing";

// Text of a number that does not depend on the locale, and is the shortest that reads back to the same value.
template <class Number> std::string text_of(Number value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string in_quotes(std::string_view text) { return "'" + std::string(text) + "'"; }

std::vector<std::string> names_of(std::span<const Answer> answers) {
  std::vector<std::string> names;
  for (const Answer& answer : answers) names.push_back(answer.name);
  return names;
}

float number_from(const Setting& row, std::string_view text) {
  float value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  if (whole && value >= row.low && value <= row.high) return value; // NaN is in no range
  const std::string unit = row.unit.empty() ? "" : " " + std::string(row.unit);
  throw SettingError(std::string(row.name) + " is a number from " + text_of(row.low) + " to " +
                     text_of(row.high) + unit + ", not " + in_quotes(text));
}

uint32_t answer_from(const Setting& row, std::string_view text) {
  const auto found = std::ranges::find(row.answers, text, &Answer::name);
  if (found != row.answers.end()) return found->value;
  std::vector<std::string> names = names_of(row.answers);
  if (row.kind == SettingKind::flags) names.emplace_back(empty_flags);
  throw SettingError(std::string(row.name) + " has no " + in_quotes(text) + did_you_mean(text, names));
}

uint32_t flags_from(const Setting& row, std::string_view text) {
  if (text == empty_flags) return 0;
  if (("," + std::string(text) + ",").find("," + std::string(empty_flags) + ",") != std::string::npos)
    throw SettingError(std::string(row.name) + "=" + std::string(empty_flags) + " stands alone, not in " +
                       in_quotes(text));
  uint32_t flags = 0;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(',', begin), text.size());
    flags |= answer_from(row, text.substr(begin, end - begin));
    begin = end + 1;
  }
  return flags;
}

std::string flags_text(const Setting& row, uint32_t flags) {
  std::string text;
  for (const Answer& answer : row.answers)
    if ((flags & answer.value) != 0) text += (text.empty() ? "" : ",") + answer.name;
  return text.empty() ? std::string(empty_flags) : text;
}

std::string text_from_json(const std::string& key, const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return text_of(value.get<double>());
  throw SettingError(key + " is a number or a word, not " + value.type_name());
}

} // namespace

std::string Setting::get(const Settings& settings) const {
  const double value = read(settings);
  if (kind == SettingKind::number) return text_of(float(value));
  if (kind == SettingKind::flags) return flags_text(*this, uint32_t(value));
  const auto found = std::ranges::find(answers, uint32_t(value), &Answer::value);
  return found == answers.end() ? std::string{} : found->name;
}

void Setting::set(Settings& settings, std::string_view value) const {
  switch (kind) {
  case SettingKind::number:
    return write(settings, number_from(*this, value));
  case SettingKind::choice:
    return write(settings, answer_from(*this, value));
  case SettingKind::flags:
    return write(settings, flags_from(*this, value));
  }
}

const Setting& find_setting(std::string_view name) {
  std::vector<std::string> names;
  for (const Setting& row : settings_table()) {
    if (row.name == name) return row;
    names.emplace_back(row.name);
  }
  throw SettingError("there is no setting " + in_quotes(name) + did_you_mean(name, names));
}

void apply_setting(Settings& settings, std::string_view assignment) {
  const size_t equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw SettingError("a setting is given as name=value, not " + in_quotes(assignment));
  find_setting(assignment.substr(0, equals)).set(settings, assignment.substr(equals + 1));
}

Settings settings_for_mode(std::string_view mode) {
  if (const TaaMode* row = find_taa_mode(mode)) {
    Settings settings;
    settings.taa = row->settings;
    return settings;
  }
  std::vector<std::string> names;
  for (const TaaMode& row : taa_modes()) names.emplace_back(row.name);
  throw SettingError("there is no mode " + in_quotes(mode) + did_you_mean(mode, names));
}

ModeRun mode_run(const std::string& text) {
  Settings settings = settings_for_mode(base_of_mode(text));
  std::vector<const Setting*> changed;
  for (const std::string& change : changes_of_mode(text)) {
    apply_setting(settings, change);
    const Setting& row = *changed.emplace_back(&find_setting(change.substr(0, change.find('='))));
    if (!row.per_mode)
      throw SettingError(in_quotes(text) + ": " + std::string(row.name) +
                         " is not a mode's own; --set sets it for all");
  }
  for (const Setting* row : changed) {
    if (std::ranges::count(changed, row) > 1)
      throw SettingError(in_quotes(text) + " says " + std::string(row->name) + " more than once");
    if (!row->used.met_by(settings))
      throw SettingError(in_quotes(text) + ": " + std::string(row->name) +
                         " has no effect: " + std::string(row->used.otherwise));
  }
  return {.name = text, .taa = settings.taa};
}

std::optional<std::string> refusal(const Settings& settings) {
  const TaaPolicy& policy = settings.taa.policy;
  const TaaSettings& taa = settings.taa;
  if (has(policy.reject, Reject::near_moving) && taa.near_m > 0 && taa.far_m > 0 && taa.near_m >= taa.far_m)
    return "near (" + text_of(settings.taa.near_m) + " m) must be less than far (" +
           text_of(settings.taa.far_m) + " m): between them the history fades in";
  if (policy.keeps == Keeps::input && policy.blend == Blend::counting)
    return "keeps=input has but one frame of history, which blend=counting could not count";
  if (policy.axes_are_of_rgb() && (policy.space != Space::rgb || policy.weighting != Weighting::none))
    return "axes=" + std::string(spelling(policy.axes)) + " were found for linear RGB, and " +
           (policy.space != Space::rgb ? "space=" + std::string(spelling(policy.space))
                                       : "weighting=" + std::string(spelling(policy.weighting))) +
           " is another space";
  if (policy.blend == Blend::attenuated && policy.rectify == Rectify::none)
    return "blend=attenuated acts where a history is rectified, and rectify=none does not";
  if (policy.needs_history()) return std::nullopt;
  for (const Setting& row : settings_table())
    if (row.per_mode && row.kind != SettingKind::number && !row.used.met_by(settings) &&
        row.read(settings) != row.read(Settings{}))
      return std::string(row.name) + "=" + row.get(settings) +
             " has no effect: " + std::string(row.used.otherwise);
  return std::nullopt;
}

nlohmann::json settings_json(const Settings& settings, SettingsPart part) {
  nlohmann::json object = nlohmann::json::object();
  for (const Setting& row : settings_table()) {
    if (part != SettingsPart::all && row.per_mode != (part == SettingsPart::per_mode)) continue;
    const std::string text = row.get(settings);
    if (row.kind != SettingKind::number) {
      object[std::string(row.name)] = text;
      continue;
    }
    double value = 0; // of the text, so that 0.1f is written as 0.1
    std::from_chars(text.data(), text.data() + text.size(), value);
    object[std::string(row.name)] = value;
  }
  return object;
}

void apply_settings_json(Settings& settings, const nlohmann::json& object) {
  if (!object.is_object()) throw SettingError("settings are an object of names and values");
  for (const auto& [key, value] : object.items()) find_setting(key).set(settings, text_from_json(key, value));
}

} // namespace unghost
