#include <algorithm>
#include <cmath>

#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"

namespace unghost {
namespace {

std::string percent(double share) { return (share < 0 ? "−" : "+") + number(std::abs(100 * share), 1) + "%"; }

std::string case_of(const Change& change) {
  std::string text = change.scene + ", " + change.rig + ", " + std::to_string(change.width) + "x" +
                     std::to_string(change.height) + ", seed " + std::to_string(change.seed);
  for (const std::string& set : change.set) text += ", " + set;
  return text;
}

std::string row_of(const Change& change, const Looks& looks) {
  const auto kind = std::ranges::find(figure_kinds(), change.figure, &FigureKind::name);
  const std::string verdict(name_of(change.verdict));
  const auto cell = [](double value, const std::string& text) {
    return "<td data-value=\"" + nlohmann::json(value).dump() + "\">" + text + "</td>";
  };
  return "<tr><th scope=\"row\">" +
         (looks.contains(change.mode) ? mode_html(change.mode, looks) : escaped(change.mode)) + "</th><td>" +
         escaped(case_of(change)) + "</td><td>" + std::string(kind->label) + "</td>" +
         cell(change.before, number(change.before, kind->decimals)) +
         cell(change.after, number(change.after, kind->decimals)) +
         cell(change.change, percent(change.change)) + "<td>" + percent(change.low) + " to " +
         percent(change.high) + "</td><td>" + (change.regression ? "<strong>regression</strong>" : verdict) +
         "</td></tr>\n";
}

std::string table_of(const std::vector<Change>& changes, const Looks& looks) {
  std::string html = "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"Changes\"><table "
                     "class=\"changes sortable\"><thead><tr>";
  for (const char* head : {"mode", "where", "figure", "before", "after", "change", "95% of it", "verdict"})
    html += std::string("<th scope=\"col\"><span class=\"head\">") + head + "</span></th>";
  html += "</tr></thead><tbody>\n";
  for (const Change& change : changes) html += row_of(change, looks);
  return html + "</tbody></table></div>\n";
}

} // namespace

std::string baseline_section(const Baseline& baseline, const Looks& looks) {
  const BaselineComparison& comparison = baseline.comparison;
  std::vector<Change> changes = differences(comparison);
  const auto noise = std::ranges::find(changes, Verdict::noise, &Change::verdict);
  const std::vector<Change> of_noise(noise, changes.end());
  changes.erase(noise, changes.end());
  const size_t same = comparison.changes.size() - changes.size() - of_noise.size();
  std::string html = "<section id=\"baseline\"><h2>Since " + escaped(baseline.file) + "</h2>\n<p>Of " +
                     std::to_string(comparison.changes.size()) + " figures " +
                     std::to_string(changes.size()) + " have changed, " + std::to_string(of_noise.size()) +
                     " differ by no more than frames and rounds do among themselves, and " +
                     std::to_string(same) + " are the same in every sample. " +
                     std::to_string(regressions(comparison)) + " are worse by more than " +
                     number(100 * comparison.allowed_share, 1) + "%.</p>\n";
  if (!changes.empty()) html += table_of(changes, looks);
  if (!of_noise.empty())
    html += "<details><summary>Noise: intervals that hold 0</summary>" + table_of(of_noise, looks) +
            "</details>\n";
  for (const std::string& sentence : comparison.missing)
    html += "<p class=\"note\">" + escaped(sentence) + "</p>\n";
  return html + "</section>\n";
}

} // namespace unghost
