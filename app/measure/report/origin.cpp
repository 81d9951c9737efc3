#include <algorithm>

#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"

namespace unghost {
namespace {

using nlohmann::json;

std::string item(const std::string& name, const std::string& value) {
  return value.empty() ? "" : "<dt>" + escaped(name) + "</dt><dd>" + escaped(value) + "</dd>";
}

std::string text_of(const json& value) {
  return value.is_string() ? value.get<std::string>()
                           : value.dump(-1, ' ', false, json::error_handler_t::replace);
}

/// Names joined by dots, values as text.
void flatten(const json& object, const std::string& prefix, std::string& html) {
  for (const auto& [name, value] : object.items())
    if (value.is_object())
      flatten(value, prefix + name + ".", html);
    else
      html += item(prefix + name, text_of(value));
}

std::string joined(const auto& values) {
  std::string text;
  for (const auto& value : values) {
    if (!text.empty()) text += ", ";
    if constexpr (std::is_convertible_v<decltype(value), std::string>)
      text += value;
    else
      text += std::to_string(value);
  }
  return text;
}

std::string timing_items(const Timing& timing) {
  return item("times taken on", timing.host) + item("with rig", timing.rig) +
         item("rounds", std::to_string(timing.rounds)) +
         item("full-screen copy", milliseconds(timing.copy_ms) + " ms") +
         item("motion pass", milliseconds(timing.motion_ms) + " ms");
}

/// Settings in which the modes differ: a line a mode. What all have alike stands once below.
std::string mode_settings(const Measured& m) {
  std::vector<std::string> names;
  for (const auto& mode : m.modes)
    for (const auto& [name, value] : mode.second.items())
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  const auto value_of = [](const json& settings, const std::string& name) {
    return settings.contains(name) ? text_of(settings.at(name)) : std::string("–");
  };
  std::string alike, heads, rows;
  std::vector<std::string> differ;
  for (const std::string& name : names) {
    const std::string first = value_of(m.modes.front().second, name);
    const bool all =
        std::ranges::all_of(m.modes, [&](const auto& mode) { return value_of(mode.second, name) == first; });
    if (all)
      alike += item(name, first);
    else
      differ.push_back(name);
  }
  for (const std::string& name : differ) heads += "<th scope=\"col\">" + escaped(name) + "</th>";
  for (const auto& [mode, settings] : m.modes) {
    rows += "<tr><th scope=\"row\">" + escaped(mode) + "</th>";
    for (const std::string& name : differ) rows += "<td>" + escaped(value_of(settings, name)) + "</td>";
    rows += "</tr>\n";
  }
  return "<h4>Of each mode</h4><div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Settings of "
         "the modes\">"
         "<table class=\"settings\"><thead><tr><th scope=\"col\">mode</th>" +
         heads + "</tr></thead><tbody>\n" + rows + "</tbody></table></div>" +
         (alike.empty() ? "" : "<h4>Alike in all modes</h4><dl>" + alike + "</dl>");
}

std::string origin_of(const Measured& m, const Results& results) {
  std::string shared;
  if (m.settings.is_object()) flatten(m.settings, "", shared);
  return "<details><summary>" + escaped(case_name(m, results)) + "</summary><dl>" +
         item("program", m.version) + item("build", m.build + (m.debug_build ? ", for debugging" : "")) +
         item("device", m.device + (m.software ? ", in software" : "")) + item("driver", m.driver) +
         item("validation", m.validation ? "on" : "off") + item("seed", std::to_string(m.seed)) +
         item("frames",
              std::to_string(m.frames) + ", the first " + std::to_string(m.fill) + " fill the history") +
         item("samples of the reference", m.samples > 0 ? std::to_string(m.samples) : "") +
         item("reference at frames", joined(m.error_frames)) + item("asked for", joined(m.set)) +
         (m.timing ? timing_items(*m.timing) : "") + "</dl>" + (m.modes.empty() ? "" : mode_settings(m)) +
         (shared.empty() ? "" : "<h4>Shared by all modes</h4><dl>" + shared + "</dl>") + "</details>\n";
}

} // namespace

std::string origin_section(const Results& results) {
  std::string html, figures;
  for (const Measured& m : results.scenes) html += origin_of(m, results);
  for (const FigureKind& kind : figure_kinds())
    figures += item(std::string(kind.label) + (kind.unit.empty() ? "" : ", " + std::string(kind.unit)),
                    std::string(kind.summary));
  return html + "<details><summary>What the figures mean</summary><dl class=\"long\">" + figures +
         "</dl></details>\n";
}

} // namespace unghost
