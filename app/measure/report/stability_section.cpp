#include <algorithm>

#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"

namespace unghost {
namespace {

std::string cell_html(const StabilityCell* cell) {
  if (cell == nullptr) return "<td class=\"none\">-</td>";
  const char* verdict = !cell->pass ? "fails" : cell->excuse.empty() ? "passes" : "excused";
  const std::string text = escaped(value_text(cell->value));
  const std::string why = cell->excuse.empty() ? cell->worst : cell->excuse + " (" + cell->worst + ")";
  return "<td class=\"" + std::string(verdict) + "\" title=\"" + escaped(why) + "\">" +
         (cell->pass ? text : "<strong>" + text + "</strong>") + (cell->excuse.empty() ? "" : "~") + "</td>";
}

std::string heads_of(const StabilityTable& table) {
  std::string heads = "<tr><th scope=\"col\">mode</th>", bounds = "<tr><th scope=\"row\">at most</th>";
  for (const StabilityColumn& column : table.columns) {
    heads += "<th scope=\"col\" title=\"" + escaped(column.summary) + "\">" + escaped(column.name) + "</th>";
    bounds += "<td>" + escaped(value_text(column.bound)) + "<small>" + escaped(column.unit) + "</small></td>";
  }
  return "<thead>" + heads + "</tr>" + bounds + "</tr></thead>";
}

/// What each case asks, and the mode that came nearest to its bound.
std::string cases_html(const StabilityTable& table) {
  std::string html = "<dl class=\"cases-asked\">\n";
  for (const StabilityColumn& column : table.columns)
    html += "<dt>" + escaped(column.name) + "</dt><dd>" + escaped(column.summary) + "</dd>\n";
  return html + "</dl>\n";
}

} // namespace

std::string stability_section(const StabilityTable& table, const Looks& looks) {
  const auto failed = std::ranges::count(table.cells, false, &StabilityCell::pass);
  std::string html =
      "<section id=\"stability\"><h2>Stiff and extreme cases</h2>\n<p>" + std::to_string(table.cells.size()) +
      " figures of the " + escaped(table.endurance) + " matrix, seed " + std::to_string(table.seed) +
      ", on " + escaped(table.device) + ": " +
      (failed == 0 ? "none is over its bound" : std::to_string(failed) + " over the bound, in bold") +
      ". Rows that are named by a setting are answers that no mode uses. ~ is over the bound, as that mode "
      "says "
      "that it may be.</p>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" "
      "aria-label=\"Stability\"><table "
      "class=\"stability\">" +
      heads_of(table) + "<tbody>\n";
  for (const std::string& mode : modes_of(table)) {
    html +=
        "<tr><th scope=\"row\">" + (looks.contains(mode) ? mode_html(mode, looks) : escaped(mode)) + "</th>";
    for (const StabilityColumn& column : table.columns)
      html += cell_html(find_cell(table, mode, column.name));
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n" + cases_html(table) + "</section>\n";
}

} // namespace unghost
