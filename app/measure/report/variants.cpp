#include "app/measure/report/variants.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "app/measure/bootstrap.h"
#include "app/measure/report/ablation.h"
#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"
#include "renderer/mode_names.h"

namespace unghost {
namespace {

/// As --modes takes them after the mode's name and a colon.
std::string settings_in(const std::string& mode) { return mode.substr(mode.find(':') + 1); }

const MeasuredMode* row_of(const Measured& m, const std::string& mode) {
  const auto row = std::ranges::find(m.rows, mode, &MeasuredMode::mode);
  return row == m.rows.end() ? nullptr : &*row;
}

std::optional<double> figure_in(const MeasuredMode& row, const FigureKind& kind) {
  const auto found = row.figures.find(std::string(kind.name));
  return found == row.figures.end() ? std::nullopt : std::optional(found->second);
}

/// In the order in which they were named.
std::vector<std::string> variants_of(const Results& results, const std::string& base) {
  std::vector<std::string> names;
  for (const Measured& m : results.scenes)
    for (const MeasuredMode& row : m.rows)
      if (is_variant(m, row.mode) && base_of_mode(row.mode) == base &&
          std::ranges::count(names, row.mode) == 0)
        names.push_back(row.mode);
  return names;
}

/// One row and its variants, of one case.
struct Family {
  const MeasuredMode* base;
  std::vector<const MeasuredMode*> variants;
  std::vector<const FigureKind*> kinds; // that any of them has
};

Family family_of(const Measured& m, const std::string& base, const std::vector<std::string>& variants) {
  Family family{.base = row_of(m, base), .variants = {}, .kinds = {}};
  if (family.base == nullptr) return family;
  for (const std::string& variant : variants)
    if (const MeasuredMode* row = row_of(m, variant); row != nullptr) family.variants.push_back(row);
  for (const FigureKind& kind : figure_kinds()) {
    const auto has = [&](const MeasuredMode* row) { return figure_in(*row, kind).has_value(); };
    if (kind.shown && (has(family.base) || std::ranges::any_of(family.variants, has)))
      family.kinds.push_back(&kind);
  }
  return family;
}

std::string figure_text(double value, const FigureKind& kind) {
  return kind.unit == "ms" ? milliseconds(value) : number(value, kind.decimals);
}

/// What a reader has of it. Milliseconds of fast devices have as many decimals as they need.
double read_figure(double value, const FigureKind& kind) {
  return kind.unit == "ms" ? value : as_read(value, kind.decimals);
}

/// Whether their rounds tell the times of two rows apart; nothing where too few have come along to know.
std::optional<bool> told_apart(const MeasuredMode& was, const MeasuredMode& is, const FigureKind& kind) {
  const auto before = was.samples.find(std::string(kind.name)),
             after = is.samples.find(std::string(kind.name));
  if (before == was.samples.end() || after == is.samples.end()) return std::nullopt;
  if (std::min(before->second.size(), after->second.size()) < 2) return std::nullopt;
  constexpr double least = 1e-9;
  const RelativeChange change = change_of_medians(before->second, after->second, least);
  return change.low > 0 || change.high < 0;
}

std::string missing_cell(const MeasuredMode& row, const FigureKind& kind) {
  const bool never = kind.time && changes_only_jitter(row.mode);
  return std::string("<td class=\"none\" title=\"") +
         (never ? "Times are taken without jitter, where this row is no other."
                : "Not measured, or there is none here.") +
         "\">–</td>";
}

constexpr double tellable = 10; // times as much: a percentage of what there was says little of what there is

/// Whether a reader takes both for the same.
bool read_alike(const MeasuredMode& was, const MeasuredMode& is, const FigureKind& kind) {
  if (kind.time && told_apart(was, is, kind) == false) return true;
  const double before = figure_in(was, kind).value_or(0), after = *figure_in(is, kind);
  return read_figure(before, kind) == read_figure(after, kind) || std::abs(after / before - 1) < 0.005;
}

/// "+12%", "to 0.423", and which way it went.
std::string change_cell(const MeasuredMode& was_row, const MeasuredMode& is_row, const FigureKind& kind) {
  const std::optional<double> is = figure_in(is_row, kind);
  if (!is) return missing_cell(is_row, kind);
  if (read_alike(was_row, is_row, kind)) return "<td class=\"none\">≈</td>";
  const double was = figure_in(was_row, kind).value_or(0);
  const bool whole = read_figure(was, kind) <= 0 || *is > tellable * was;
  const double percent = whole ? 0 : std::round(100 * (*is / was - 1));
  const std::string text =
      whole ? "to " + figure_text(*is, kind) : (percent > 0 ? "+" : "−") + number(std::abs(percent), 0) + "%";
  return *is > was ? "<td><strong>" + text + "</strong></td>" : "<td>" + text + "</td>";
}

/// By name where it is known, and always as --modes takes it.
std::string row_head(const std::string& mode) {
  const std::string code = "<code>" + escaped(settings_in(mode)) + "</code>";
  const Part* part = find_part(mode);
  return "<th scope=\"row\">" +
         (part == nullptr ? code : escaped(part->name) + "<small>" + code + "</small>") + "</th>";
}

std::string table_head(const Family& family, const std::string& caption) {
  std::string html = "<table class=\"variants\"><caption>" + caption +
                     "</caption><thead><tr><th scope=\"col\">" + escaped(family.base->mode) + "</th>";
  for (const FigureKind* kind : family.kinds)
    html += "<th scope=\"col\" title=\"" + escaped(kind->summary) + "\">" + escaped(kind->label) +
            (kind->unit.empty() ? "" : " <small>" + escaped(kind->unit) + "</small>") + "</th>";
  html += "</tr></thead><tbody>\n<tr><th scope=\"row\">as it is</th>";
  for (const FigureKind* kind : family.kinds) {
    const std::optional<double> figure = figure_in(*family.base, *kind);
    html += figure ? "<td>" + figure_text(*figure, *kind) + "</td>" : missing_cell(*family.base, *kind);
  }
  return html + "</tr>\n";
}

std::string table_of(const Measured& m, const Results& results, const Family& family) {
  const bool lent = m.timing && m.timing->rig != m.rig;
  std::string html = table_head(
      family, escaped(case_name(m, results)) +
                  (lent ? " <small>with the times of " + escaped(m.timing->rig) + "</small>" : ""));
  for (const MeasuredMode* variant : family.variants) {
    html += "<tr>" + row_head(variant->mode);
    for (const FigureKind* kind : family.kinds) html += change_cell(*family.base, *variant, *kind);
    html += "</tr>\n";
  }
  return html + "</tbody></table>\n";
}

std::string tables_of(const Results& results, const std::string& base) {
  const std::vector<std::string> variants = variants_of(results, base);
  std::string html = "<h3>" + escaped(base) + "</h3>\n" + parts_explained(variants) +
                     "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped(base) +
                     ", one part changed\">";
  for (const Measured& m : results.scenes)
    if (const Family family = family_of(m, base, variants); !family.variants.empty())
      html += table_of(m, results, family);
  return html + "</div>\n";
}

/// Rows that were changed, by name.
std::set<std::string> bases_in(const Results& results) {
  std::set<std::string> bases;
  for (const Measured& m : results.scenes)
    for (const MeasuredMode& row : m.rows)
      if (is_variant(m, row.mode)) bases.insert(base_of_mode(row.mode));
  return bases;
}

} // namespace

bool is_variant(const Measured& m, const std::string& mode) {
  return base_of_mode(mode) != mode && row_of(m, base_of_mode(mode)) != nullptr;
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

bool is_of_variants(const Results& results) {
  const std::set<std::string> bases = bases_in(results);
  return !bases.empty() && std::ranges::all_of(results.scenes, [&](const Measured& m) {
    return std::ranges::all_of(
        m.rows, [&](const MeasuredMode& row) { return is_variant(m, row.mode) || bases.contains(row.mode); });
  });
}

std::string variants_section(const Results& results) {
  std::string html;
  for (const std::string& base : bases_in(results)) html += tables_of(results, base);
  if (html.empty()) return html;
  return "<section id=\"variants\"><h2>One part changed at a time</h2>\n<p>The first row is what the mode "
         "itself has. Each row below it changes what stands below its name, and says how much more or less "
         "of each figure there is then, in percent; more, which is worse, in bold. What becomes more than " +
         number(tellable, 0) +
         " times as large is told as it is (<q>to 0.423</q>): of next to nothing a percentage says nothing. "
         "≈ is the same: figures that read alike or differ by less than half a percent, and times that the "
         "rounds do not tell apart (the 95% interval of their change holds 0). – was not measured: times are "
         "taken without jitter, where a row that changes the jitter is no other. What stands below a name is "
         "what <code>--modes</code> takes after the mode's name and a colon.</p>\n" +
         html + "</section>\n";
}

} // namespace unghost
