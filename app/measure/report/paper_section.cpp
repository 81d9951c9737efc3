#include <algorithm>
#include <cmath>

#include "app/measure/report/html.h"
#include "app/measure/report/paper_tables.h"
#include "app/measure/report/sections.h"

namespace unghost {
namespace {

double figure_or_nan(const Measured& m, std::string_view mode, const char* figure) {
  const auto row = std::ranges::find(m.rows, mode, &MeasuredMode::mode);
  if (row == m.rows.end()) return NAN;
  const auto found = row->figures.find(figure);
  return found == row->figures.end() ? NAN : found->second;
}

/// One column of the table, theirs and ours.
struct Compared {
  const char* head;
  int decimals;
  std::vector<double> theirs, ours;
};

std::vector<Compared> compared(const PaperTable& table, const Measured& m) {
  Compared time{"time over RGB", 2, {}, {}}, shimmer{"shimmer", 4, {}, {}}, ghosting{"ghosting", 4, {}, {}};
  const PaperRow& first = table.rows.front();
  const double of_first = figure_or_nan(m, first.mode, "over_copy"); // of the resolve alone, as theirs
  for (const PaperRow& row : table.rows) {
    time.theirs.push_back(row.ms / first.ms);
    time.ours.push_back(figure_or_nan(m, row.mode, "over_copy") / of_first);
    shimmer.theirs.push_back(row.shimmer), shimmer.ours.push_back(figure_or_nan(m, row.mode, "shimmer"));
    ghosting.theirs.push_back(row.ghosting), ghosting.ours.push_back(figure_or_nan(m, row.mode, "ghosting"));
  }
  return {time, shimmer, ghosting};
}

/// A figure, and beside it a bar of its share of the column's largest.
std::string cell(double value, int decimals, const std::vector<double>& column) {
  if (!std::isfinite(value)) return "<td class=\"none\">–</td>";
  double most = 0;
  for (const double other : column)
    if (std::isfinite(other)) most = std::max(most, other);
  const double length = most > 0 ? 30 * value / most : 0;
  return "<td>" + number(value, decimals) +
         "<svg class=\"bar\" viewBox=\"0 0 30 8\" width=\"30\" height=\"8\" aria-hidden=\"true\"><rect "
         "width=\"" +
         number(std::max(0., length), 1) + "\" height=\"8\"/></svg></td>";
}

std::string verdict(const PaperTable& table, const Compared& column) {
  const auto as_shown = [&](std::vector<double> values) { // what reads alike has no order
    for (double& value : values) value = as_read(value, column.decimals);
    return values;
  };
  const OrderComparison order = compare_orders(as_shown(column.theirs), as_shown(column.ours));
  if (order.pairs == 0) return {};
  std::string text = "<li><strong>" + std::string(column.head) + "</strong>: " + std::to_string(order.alike) +
                     " of " + std::to_string(order.pairs) + " pairs are in the same order";
  if (order.tied > 0)
    text +=
        ", " + std::to_string(order.tied) + (order.tied == 1 ? " has" : " have") + " none (equal figures)";
  for (size_t i = 0; i < order.unlike.size(); ++i) {
    auto [a, b] = order.unlike[i];
    if (column.theirs[a] > column.theirs[b]) std::swap(a, b);
    text += (i == 0 ? "; not: <span class=\"pair\">" : ", <span class=\"pair\">") +
            std::string(table.rows[a].mode) + " &lt; " + std::string(table.rows[b].mode) + "</span>";
  }
  return text + (order.unlike.empty() ? "" : " (as the paper has them)") + ".</li>\n";
}

std::string comparison(const PaperTable& table, const Measured& m, const Results& results) {
  const std::vector<Compared> columns = compared(table, m);
  std::string html = "<h3>" + escaped(table.title) + ", beside " + escaped(case_name(m, results)) +
                     "</h3>\n<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" +
                     escaped(table.title) +
                     "\"><table class=\"paper\"><thead><tr><th scope=\"col\" rowspan=\"2\">method</th>";
  for (const Compared& column : columns)
    html += std::string("<th scope=\"colgroup\" colspan=\"2\">") + column.head + "</th>";
  html += "</tr><tr>";
  for (size_t i = 0; i < columns.size(); ++i)
    html += "<th scope=\"col\">paper</th><th scope=\"col\">ours</th>";
  html += "</tr></thead><tbody>\n";
  for (size_t i = 0; i < table.rows.size(); ++i) {
    html += "<tr><th scope=\"row\">" + escaped(table.rows[i].method) + " <small>" +
            escaped(table.rows[i].mode) + "</small></th>";
    for (const Compared& column : columns)
      html += cell(column.theirs[i], column.decimals, column.theirs) +
              cell(column.ours[i], column.decimals, column.ours);
    html += "</tr>\n";
  }
  html += "</tbody></table></div>\n<ul class=\"verdicts\">";
  for (const Compared& column : columns) html += verdict(table, column);
  return html + "</ul>\n";
}

bool shows(const Measured& m, const PaperTable& table) {
  if (!is_of(table, m)) return false;
  const auto measured = [&](const PaperRow& row) {
    return std::ranges::find(m.rows, row.mode, &MeasuredMode::mode) != m.rows.end();
  };
  return std::ranges::count_if(table.rows, measured) > 1;
}

} // namespace

std::string paper_section(const Results& results, const PageNotes& notes) {
  std::string html;
  for (const PaperTable& table : paper_tables())
    for (const Measured& m : results.scenes)
      if (shows(m, table)) html += comparison(table, m, results);
  if (html.empty())
    html =
        "<p>Its rows were not measured on a scene and rig that show what it shows: asphalt with rig drive, "
        "or grass "
        "with rig kick.</p>\n";
  else
    html = "<p>Ikkala et al. 2024, “k-DOP Clipping”, on other scenes and another device: what can be "
           "compared is the order. Shimmer and ghosting are mean FLIP; times are those of the resolve, as "
           "ratios to RGB.</p>\n" +
           html;
  for (const std::string& paragraph : notes.paragraphs) html += "<p>" + escaped(paragraph) + "</p>\n";
  return html;
}

} // namespace unghost
