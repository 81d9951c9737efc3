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

/// A line a case: what it asks, and who came nearest to its bound, or went over it.
std::string cases_html(const StabilityTable& table) {
  std::string html =
      "<table class=\"cases-asked\"><thead><tr><th scope=\"col\">case</th><th scope=\"col\">what is "
      "asked</th><th scope=\"col\">at most</th><th scope=\"col\">worst</th><th "
      "scope=\"col\">where</th></tr></thead><tbody>\n";
  for (const StabilityColumn& column : table.columns) {
    const StabilityCell* worst = worst_cell(table, column.name);
    html += "<tr><th scope=\"row\">" + escaped(column.name) + "</th><td>" + escaped(column.summary) +
            "</td><td>" + escaped(value_text(column.bound)) + " " + escaped(column.unit) + "</td>" +
            cell_html(worst) + "<td>";
    if (worst != nullptr && worst->value != 0.0)
      html += escaped((worst->mode == every_mode ? "" : worst->mode + ": ") + worst->worst);
    html += "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string excuses_html(const StabilityTable& table) {
  std::string items;
  for (const StabilityCell& cell : table.cells)
    if (!cell.excuse.empty())
      items += "<li>" + escaped(cell.mode) + " in " + escaped(cell.column) + ", " +
               escaped(value_text(cell.value)) + ": " + escaped(cell.excuse) + "</li>\n";
  return items.empty()
             ? items
             : "<p>Over the bound, as these modes say that they may be:</p>\n<ul>\n" + items + "</ul>\n";
}

std::string every_cell_html(const StabilityTable& table, const Looks& looks) {
  std::string html =
      "<details><summary>Every mode in every case</summary>\n<p>Rows that are named by a setting are "
      "answers that no mode uses; ~ is excused.</p>\n<div class=\"wide\" tabindex=\"0\" "
      "role=\"region\" aria-label=\"Stability\"><table class=\"stability\">" +
      heads_of(table) + "<tbody>\n";
  for (const std::string& mode : modes_of(table)) {
    html +=
        "<tr><th scope=\"row\">" + (looks.contains(mode) ? mode_html(mode, looks) : escaped(mode)) + "</th>";
    for (const StabilityColumn& column : table.columns)
      html += cell_html(find_cell(table, mode, column.name));
    html += "</tr>\n";
  }
  return html + "</tbody></table></div></details>\n";
}

} // namespace

std::string stability_section(const StabilityTable& table, const Looks& looks) {
  const auto failed = std::ranges::count(table.cells, false, &StabilityCell::pass);
  const size_t missing = missing_cells(table);
  return "<section id=\"stability\"><h2>Stiff and extreme cases</h2>\n<p>" +
         std::to_string(table.cells.size()) + " figures of the " + escaped(table.endurance) +
         " matrix, seed " + std::to_string(table.seed) + ", on " + escaped(table.device) + ": " +
         (failed == 0 ? "none is over its bound" : std::to_string(failed) + " over the bound, in bold") +
         (missing == 0 ? "" : "; <strong>" + std::to_string(missing) + " are missing</strong>") + ".</p>\n" +
         cases_html(table) + excuses_html(table) + every_cell_html(table, looks) + "</section>\n";
}

} // namespace unghost
