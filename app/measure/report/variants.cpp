#include "app/measure/report/variants.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/measure/report/ablation.h"
#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"

namespace unghost {
namespace {

std::string base_of(const std::string& mode) { return mode.substr(0, mode.find(':')); }

const MeasuredMode* row_of(const Measured& m, const std::string& mode) {
  const auto row = std::ranges::find(m.rows, mode, &MeasuredMode::mode);
  return row == m.rows.end() ? nullptr : &*row;
}

std::optional<double> figure_of(const Measured& m, const std::string& mode, const FigureKind& kind) {
  const MeasuredMode* row = row_of(m, mode);
  if (row == nullptr || !row->figures.contains(std::string(kind.name))) return {};
  return row->figures.at(std::string(kind.name));
}

/// In the order in which they were named.
std::vector<std::string> variants_of(const Results& results, const std::string& base) {
  std::vector<std::string> names;
  for (const Measured& m : results.scenes)
    for (const MeasuredMode& row : m.rows)
      if (is_variant(m, row.mode) && base_of(row.mode) == base && std::ranges::count(names, row.mode) == 0)
        names.push_back(row.mode);
  return names;
}

/// "+12%", and which way it went; what the row itself has is too little to be compared with, or is none.
std::string change_cell(std::optional<double> was, std::optional<double> is, const FigureKind& kind) {
  if (!was || !is) return "<td class=\"none\">–</td>";
  if (as_read(*was, kind.decimals) == 0) return "<td>" + number(*is, kind.decimals) + "</td>";
  const double percent = std::round(100 * (*is / *was - 1));
  const std::string text =
      percent == 0 ? "0" : (percent > 0 ? "+" : "−") + number(std::abs(percent), 0) + "%";
  return percent > 0 ? "<td><strong>" + text + "</strong></td>" : "<td>" + text + "</td>";
}

std::string table_of(const Results& results, const std::string& base,
                     const std::vector<std::string>& variants, const FigureKind& kind) {
  std::vector<const Measured*> cases;
  for (const Measured& m : results.scenes)
    if (figure_of(m, base, kind)) cases.push_back(&m);
  if (cases.empty()) return {};
  std::string html = "<table class=\"variants\"><caption>" + escaped(kind.label) +
                     "</caption><thead><tr><th scope=\"col\">" + escaped(base) + " with</th>";
  for (const Measured* m : cases) html += "<th scope=\"col\">" + escaped(case_name(*m, results)) + "</th>";
  html += "</tr></thead><tbody>\n<tr><th scope=\"row\">nothing else</th>";
  for (const Measured* m : cases)
    html += "<td>" + number(*figure_of(*m, base, kind), kind.decimals) + "</td>";
  html += "</tr>\n";
  for (const std::string& variant : variants) {
    html += "<tr><th scope=\"row\">" + escaped(change_of(variant)) + "</th>";
    for (const Measured* m : cases)
      html += change_cell(figure_of(*m, base, kind), figure_of(*m, variant, kind), kind);
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

} // namespace

std::string change_of(const std::string& mode) {
  std::string text = mode.substr(mode.find(':') + 1);
  std::ranges::replace(text, '+', ',');
  for (size_t at = 0; (at = text.find(':', at)) != std::string::npos;) text.replace(at, 1, ", ");
  return text;
}

bool is_variant(const Measured& m, const std::string& mode) {
  return mode.find(':') != std::string::npos && row_of(m, base_of(mode)) != nullptr;
}

Results without_variants(Results results) {
  for (Measured& m : results.scenes) {
    const Measured all = m;
    const auto changed = [&](const std::string& mode) { return is_variant(all, mode); };
    std::erase_if(m.modes, [&](const auto& mode) { return changed(mode.first); });
    std::erase_if(m.kept, [&](const KeptFrame& kept) { return changed(kept.mode); });
    if (m.convergence)
      std::erase_if(m.convergence->curves, [&](const ConvergenceCurve& curve) {
        return curve.kind == "mode" && changed(curve.name);
      });
    std::erase_if(m.rows, [&](const MeasuredMode& row) { return changed(row.mode); });
  }
  return results;
}

std::string variants_section(const Results& results) {
  std::set<std::string> bases;
  for (const Measured& m : results.scenes)
    for (const MeasuredMode& row : m.rows)
      if (is_variant(m, row.mode)) bases.insert(base_of(row.mode));
  std::string html;
  for (const std::string& base : bases) {
    const std::vector<std::string> variants = variants_of(results, base);
    html += "<h3>" + escaped(base) + "</h3>\n" + parts_explained(variants) +
            "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(base) +
            ", one part changed\">";
    for (const FigureKind& kind : figure_kinds())
      if (kind.shown) html += table_of(results, base, variants, kind);
    html += "</div>\n";
  }
  if (html.empty()) return html;
  return "<section id=\"variants\"><h2>One part changed at a time</h2>\n<p>How much more or less of each "
         "figure there is with one setting changed, in percent of what the mode itself has; more, which is "
         "worse, in "
         "bold.</p>\n" +
         html + "</section>\n";
}

} // namespace unghost
