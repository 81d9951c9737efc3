#include <charconv>

#include "app/measure/results.h"

namespace unghost {
namespace {

/// As RFC 4180 has it; what a spreadsheet would take for a formula is text.
std::string cell(std::string text) {
  double number = 0;
  const bool is_number =
      std::from_chars(text.data(), text.data() + text.size(), number).ptr == text.data() + text.size();
  if (!is_number && text.find_first_of("=+-@") == 0) text.insert(0, "'");
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string line_of(const std::vector<std::string>& cells) {
  std::string line;
  for (const std::string& each : cells) line += (&each == &cells.front() ? "" : ",") + cell(each);
  return line + "\r\n";
}

} // namespace

std::string results_csv(const Results& results) {
  std::vector<std::string> heads = {"scene", "rig",    "size",   "seed", "mode",
                                    "host",  "device", "driver", "build"};
  for (const FigureKind& kind : figure_kinds()) heads.emplace_back(kind.name);
  std::string csv = line_of(heads);
  for (const Measured& m : results.scenes)
    for (const MeasuredMode& row : m.rows) {
      std::vector<std::string> cells = {
          m.scene,  m.rig,    size_of(m), std::to_string(m.seed), row.mode, m.timing ? m.timing->host : "",
          m.device, m.driver, m.build};
      for (const FigureKind& kind : figure_kinds()) {
        const auto found = row.figures.find(std::string(kind.name));
        cells.push_back(found == row.figures.end() ? "" : nlohmann::json(found->second).dump());
      }
      csv += line_of(cells);
    }
  return csv;
}

} // namespace unghost
