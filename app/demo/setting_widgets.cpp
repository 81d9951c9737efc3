#include "app/demo/setting_widgets.h"

#include <algorithm>

#include <imgui.h>

namespace unghost {
namespace {

std::string words_of(const Setting& row, const Settings& usual) {
  std::string words(row.summary);
  if (row.kind == SettingKind::number) {
    Settings ends = usual;
    row.write(ends, double(row.low));
    const std::string low = row.get(ends);
    row.write(ends, double(row.high));
    words += "\nFrom " + low + " to " + row.get(ends) +
             (row.unit.empty() ? "" : " " + std::string(row.unit)) + ".";
  }
  words += "\nUsually " + row.get(usual) + ".";
  if (!row.source.empty()) words += "\nSource: " + std::string(row.source) + ".";
  return words;
}

bool edit_number(const Setting& row, Settings& settings, const char* label) {
  auto value = float(row.read(settings));
  const bool wide = row.high / std::max(row.low, 1e-3f) > 100 && row.low >= 0;
  const auto flags = ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0);
  std::string format = "%.3g";
  const std::string shown = row.get(settings) + " " + std::string(row.unit);
  const bool fits = ImGui::CalcTextSize(shown.c_str()).x < ImGui::CalcItemWidth(); // else the tooltip has it
  if (!row.unit.empty() && fits) format += " " + std::string(row.unit == "%" ? "%%" : row.unit);
  if (!ImGui::SliderFloat(label, &value, row.low, row.high, format.c_str(), flags)) return false;
  row.write(settings, double(value));
  return true;
}

bool edit_choice(const Setting& row, Settings& settings, const char* label) {
  bool changed = false;
  if (!ImGui::BeginCombo(label, row.get(settings).c_str())) return false;
  for (const Answer& answer : row.answers)
    if (ImGui::Selectable(answer.name.c_str(), uint32_t(row.read(settings)) == answer.value)) {
      row.write(settings, answer.value);
      changed = true;
    }
  ImGui::EndCombo();
  return changed;
}

bool edit_flags(const Setting& row, Settings& settings, const char* label) {
  bool changed = false;
  if (!ImGui::BeginCombo(label, row.get(settings).c_str())) return false;
  for (const Answer& answer : row.answers) {
    auto given = uint32_t(row.read(settings));
    if (!ImGui::CheckboxFlags(answer.name.c_str(), &given, answer.value)) continue;
    row.write(settings, given);
    changed = true;
  }
  ImGui::EndCombo();
  return changed;
}

bool edit(const Setting& row, Settings& settings) {
  const std::string label(row.name);
  switch (row.kind) {
  case SettingKind::number:
    return edit_number(row, settings, label.c_str());
  case SettingKind::choice:
    return edit_choice(row, settings, label.c_str());
  case SettingKind::flags:
    return edit_flags(row, settings, label.c_str());
  }
  return false;
}

/// One row; returns whether it was changed.
bool edit_row(const Setting& row, Settings& settings, const Settings& usual, std::string& message) {
  const bool used = row.used.met_by(settings);
  const bool differs = row.get(settings) != row.get(usual);
  if (differs) ImGui::PushStyleColor(ImGuiCol_Text, {1, 0.8f, 0.4f, 1});
  if (!used) ImGui::BeginDisabled();
  Settings changed = settings;
  bool taken = edit(row, changed);
  if (!used) ImGui::EndDisabled();
  if (differs) ImGui::PopStyleColor();
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled);
  if (hovered) {
    std::string words = words_of(row, usual);
    if (!used) words += "\nHere it has no effect: " + std::string(row.used.otherwise) + ".";
    if (differs) words += "\nA right click resets it.";
    tooltip(words);
  }
  if (differs && hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
    row.write(changed, row.read(usual));
    taken = true;
  }
  if (!taken) return false;
  if (const auto why = refusal(changed)) {
    message = std::string(row.name) + ": " + *why;
    return false;
  }
  settings = changed;
  return true;
}

} // namespace

bool edit_settings(Settings& settings, const Settings& usual, SettingsPart part, std::string& message) {
  bool changed = false;
  ImGui::PushItemWidth(ImGui::GetContentRegionAvail().x * 0.5f);
  for (const Setting& row : settings_table())
    if (row.per_mode == (part == SettingsPart::per_mode)) changed |= edit_row(row, settings, usual, message);
  ImGui::PopItemWidth();
  return changed;
}

void tooltip(const std::string& text) {
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

} // namespace unghost
