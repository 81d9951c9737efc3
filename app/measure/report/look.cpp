#include "app/measure/report/look.h"

#include <algorithm>
#include <array>

#include "app/measure/report/html.h"
#include "renderer/settings.h"
#include "renderer/taa_modes.h"

namespace unghost {
namespace {

constexpr std::array<std::string_view, 8> family_names = {"no rectification",  "two frames", "box",
                                                          "box and rejection", "variance",   "polytope",
                                                          "known causes",      "other"};

int family_of(const nlohmann::json& settings) {
  const auto word = [&](const char* name) {
    const auto found = settings.find(name);
    return found != settings.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const std::string rectify = word("rectify"), reject = word("reject");
  if (word("keeps") == "input") return 1;
  if (reject.find("moved-object") != std::string::npos || reject.find("visibility") != std::string::npos)
    return 6;
  if (rectify == "none") return 0;
  if (rectify.starts_with("dop")) return 5;
  if (rectify.starts_with("variance")) return 4;
  // what every mode gives up aside
  if (rectify.starts_with("box")) return reject == "off-screen" || reject == "nothing" ? 2 : 3;
  return 7;
}

} // namespace

std::span<const std::string_view> families() { return family_names; }

std::map<std::string, Look> looks_of(const Results& results) {
  std::map<std::string, Look> rows, looks;
  std::array<int, family_names.size()> members{};
  const auto next_of = [&](int family) { return Look{family, members[size_t(family)]++ % shape_count}; };
  for (const TaaMode& mode : taa_modes()) // whichever were measured, each looks the same in every report
    rows[std::string(mode.name)] =
        next_of(family_of(settings_json(settings_for_mode(std::string(mode.name)), SettingsPart::per_mode)));
  for (const Measured& m : results.scenes)
    for (const auto& [name, settings] : m.modes) {
      if (looks.contains(name)) continue;
      const int family = family_of(settings);
      const auto row = rows.find(name);
      looks[name] = row != rows.end() && row->second.family == family ? row->second : next_of(family);
    }
  return looks;
}

std::string svg_shape(int shape, double x, double y, double radius) {
  const auto at = [&](double dx, double dy) {
    return number(x + dx * radius, 1) + " " + number(y + dy * radius, 1);
  };
  const auto path = [](const std::string& d) { return "<path d=\"" + d + "\"/>"; };
  switch (shape) {
  case 0:
    return "<circle cx=\"" + number(x, 1) + "\" cy=\"" + number(y, 1) + "\" r=\"" + number(radius, 1) +
           "\"/>";
  case 1:
    return path("M" + at(-.9, -.9) + "L" + at(.9, -.9) + "L" + at(.9, .9) + "L" + at(-.9, .9) + "Z");
  case 2:
    return path("M" + at(0, -1.15) + "L" + at(1.1, .85) + "L" + at(-1.1, .85) + "Z");
  case 3:
    return path("M" + at(0, -1.3) + "L" + at(1.3, 0) + "L" + at(0, 1.3) + "L" + at(-1.3, 0) + "Z");
  case 4:
    return path("M" + at(0, 1.15) + "L" + at(1.1, -.85) + "L" + at(-1.1, -.85) + "Z");
  default: // a plus sign with body
    return path("M" + at(-.4, -1.2) + "L" + at(.4, -1.2) + "L" + at(.4, -.4) + "L" + at(1.2, -.4) + "L" +
                at(1.2, .4) + "L" + at(.4, .4) + "L" + at(.4, 1.2) + "L" + at(-.4, 1.2) + "L" + at(-.4, .4) +
                "L" + at(-1.2, .4) + "L" + at(-1.2, -.4) + "L" + at(-.4, -.4) + "Z");
  }
}

std::string svg_glyph(const Look& look) {
  return "<svg class=\"glyph f" + std::to_string(look.family) +
         "\" viewBox=\"0 0 14 14\" width=\"14\" height=\"14\" aria-hidden=\"true\">" +
         svg_shape(look.shape, 7, 7, 4.6) + "</svg>";
}

} // namespace unghost
