#include <algorithm>
#include <cmath>

#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"
#include "renderer/taa_modes.h"

namespace unghost {
namespace {

struct Column {
  const FigureKind* kind;
  double best;
  int decimals;
  bool told = false; // best of more than one
};

/// Of figures that any mode has; the aliased frame, which adds no time, wins no prize for what it is.
std::vector<Column> columns_of(const Measured& m) {
  std::vector<Column> columns;
  for (const FigureKind& kind : figure_kinds()) {
    Column column{&kind, INFINITY, kind.decimals};
    size_t count = 0;
    for (const MeasuredMode& row : m.rows) {
      const auto found = row.figures.find(std::string(kind.name));
      if (found == row.figures.end()) continue;
      ++count;
      if (as_read(found->second, kind.decimals) > 0) column.best = std::min(column.best, found->second);
    }
    column.told = count > 1;
    if (kind.unit == "ms" && std::isfinite(column.best)) // fast devices: two digits that count at least
      column.decimals = std::clamp(1 - int(std::floor(std::log10(column.best))), kind.decimals, 5);
    if (kind.shown && count > 0) columns.push_back(column);
  }
  return columns;
}

std::string cell(const MeasuredMode& row, const Column& column) {
  const auto found = row.figures.find(std::string(column.kind->name));
  if (found == row.figures.end()) return "<td class=\"none\" data-value=\"\">–</td>";
  const std::string value = number(found->second, column.decimals);
  const bool best =
      column.told && as_read(found->second, column.decimals) == as_read(column.best, column.decimals);
  return "<td data-value=\"" + nlohmann::json(found->second).dump() + "\">" +
         (best ? "<strong class=\"best\">" + value + "<span class=\"aside\"> best</span></strong>" : value) +
         "</td>";
}

bool any_above(const Measured& m, std::string_view figure, double limit) {
  return std::ranges::any_of(m.rows, [&](const MeasuredMode& row) {
    const auto found = row.figures.find(std::string(figure));
    return found != row.figures.end() && found->second > limit;
  });
}

std::string notes_of(const Measured& m) {
  std::string text =
      "Less is better everywhere; the smallest figures above 0 of a column are outlined. 0 is the "
      "aliased frame, or nothing left to measure.";
  if (is_at_rest(m) && any_above(m, "ghosting", 0))
    text +=
        " Nothing moves here: ghosting is a history that was right, and that the mode changed all the same.";
  if (any_above(m, "trail", 1) || any_above(m, "trail_surface", 1) || any_above(m, "trail_shadow", 1))
    text += " A trail above 1 is more of the ghost than a plain blend leaves.";
  return "<p class=\"note\">" + text + "</p>\n";
}

} // namespace

std::string mode_html(const std::string& mode, const Looks& looks) {
  const TaaMode* row = find_taa_mode(mode);
  const std::string summary = row == nullptr ? "" : " title=\"" + escaped(std::string(row->summary)) + "\"";
  return "<span class=\"mode\"" + summary + ">" + svg_glyph(looks.at(mode)) + escaped(mode) + "</span>";
}

std::string modes_table(const Measured& m, const Looks& looks) {
  const std::vector<Column> columns = columns_of(m);
  if (columns.empty()) return {};
  std::string html =
      "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"All modes\">"
      "<table class=\"modes sortable\"><thead><tr><th scope=\"col\"><span class=\"head\">mode</span></th>";
  for (const Column& column : columns)
    html += "<th scope=\"col\" title=\"" + escaped(column.kind->summary) + "\"><span class=\"head\">" +
            escaped(column.kind->label) + "</span>" +
            (column.kind->unit.empty() ? "" : " <small>" + escaped(column.kind->unit) + "</small>") + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const MeasuredMode& row : m.rows) {
    html += "<tr data-mode=\"" + escaped(row.mode) + "\"><th scope=\"row\">" + mode_html(row.mode, looks) +
            "</th>";
    for (const Column& column : columns) html += cell(row, column);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>" + notes_of(m);
}

} // namespace unghost
