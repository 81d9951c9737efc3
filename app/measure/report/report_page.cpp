#include "app/measure/report/report_page.h"

#include <algorithm>
#include <map>

#include "app/measure/report/embedded.h"
#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"
#include "app/measure/report/variants.h"

namespace unghost {
namespace {

using nlohmann::json;

std::string titled(const char* title, const std::string& content) {
  return content.empty() ? "" : "<h3>" + std::string(title) + "</h3>\n" + content;
}

/// The charts' figures; what the script needs of them goes into `data`.
std::string figures_of(const std::vector<Chart>& charts, json& data) {
  std::string html;
  for (const Chart& chart : charts) {
    html += figure_of(chart);
    data["charts"][chart.id] = chart_json(chart);
  }
  return html.empty() ? "" : "<div class=\"grid\">" + html + "</div>\n";
}

std::string case_section(const Measured& m, const Results& results, const Looks& looks,
                         const FindPicture& pictures, const std::string& id, json& data) {
  std::vector<Chart> spreads = time_charts(m, looks, id);
  const bool timed = !spreads.empty();
  std::ranges::move(trail_charts(m, looks, id), std::back_inserter(spreads));
  const char* spreads_title = !timed ? "Trail" : spreads.size() > 1 ? "Run time and trail" : "Run time";
  return "<section class=\"case\" id=\"" + id + "\"><h2>" + escaped(case_name(m, results)) + "</h2>\n" +
         titled("Worth having here", fronts_table(m, looks)) +
         titled("Work and precision", figures_of(work_precision(m, looks, id), data)) +
         titled("All modes", modes_table(m, looks)) +
         titled("Convergence", figures_of(convergence_charts(m, looks, id), data)) +
         titled(spreads_title, figures_of(spreads, data)) +
         titled("The same instant", instant_pictures(m, pictures)) +
         titled(results.scenes.size() > 1 ? "The worst frames, of modes that are at their worst here"
                                          : "The worst frames",
                worst_frames(m, looks, pictures, id)) +
         "</section>\n";
}

/// Every mode's mark by family: the charts' key, which the script makes a filter.
std::string key_of(const Looks& looks) {
  std::string html;
  for (size_t family = 0; family < families().size(); ++family) {
    std::string members;
    for (int shape = 0; shape < shape_count; ++shape)
      for (const auto& [mode, look] : looks)
        if (look.family == int(family) && look.shape == shape)
          members += "<span class=\"member\" data-key=\"" + escaped(mode) + "\">" + svg_glyph(look) +
                     escaped(mode) + "</span> ";
    if (!members.empty())
      html += "<div class=\"family\"><span class=\"kin\">" + std::string(families()[family]) + "</span> " +
              members + "</div>";
  }
  return "<div class=\"key\" id=\"key\" role=\"group\" aria-label=\"Modes in charts and tables\">" + html +
         "<div class=\"family\"><span class=\"kin\">beside them</span> <span class=\"rule "
         "front-rule\">Pareto front</span> "
         "<span class=\"rule reference-rule\">supersampling</span></div></div>\n";
}

/// Rigs by what else they were measured with.
std::string case_links(const Results& results) {
  if (results.scenes.size() < 2) return {};
  std::vector<std::pair<std::string, std::string>> groups;
  for (size_t i = 0; i < results.scenes.size(); ++i) {
    const std::string name = case_group(results.scenes[i], results);
    auto group = std::ranges::find(groups, name, &std::pair<std::string, std::string>::first);
    if (group == groups.end()) group = groups.insert(groups.end(), {name, {}});
    group->second +=
        "<a href=\"#case-" + std::to_string(i + 1) + "\">" + escaped(results.scenes[i].rig) + "</a> ";
  }
  std::string html = "<nav class=\"cases\" aria-label=\"Rig, scene and size\">";
  for (const auto& [name, links] : groups)
    html += "<div><span>" + escaped(name) + "</span> " + links + "</div>";
  return html + "</nav>\n";
}

/// Of the frames beside the aliased one, each mode's worst of all cases: a page of all would be too large to
/// open.
Results with_worst_frames_only(Results results) {
  std::map<std::string, double> worst;
  for (const Measured& m : results.scenes)
    for (const KeptFrame& kept : m.kept)
      if (kept.kind == "ghosting") worst[kept.mode] = std::max(worst[kept.mode], kept.flip);
  for (Measured& m : results.scenes)
    std::erase_if(m.kept, [&](const KeptFrame& kept) {
      return kept.kind == "ghosting" && (kept.flip < worst.at(kept.mode) || kept.flip == 0);
    });
  return results;
}

std::string body_of(const Results& all, const FindPicture& pictures, const PageNotes& notes) {
  const Results results = with_worst_frames_only(without_variants(all));
  const Looks looks = looks_of(results);
  json data = {{"charts", json::object()}};
  std::string cases;
  for (size_t i = 0; i < results.scenes.size(); ++i)
    cases += case_section(results.scenes[i], results, looks, pictures, "case-" + std::to_string(i + 1), data);
  const std::string variants = variants_section(all);
  const bool first = is_of_variants(all); // who asks for parts alone need not look for them
  return "<main>\n<header><h1>What each mode costs, and what it leaves behind</h1>\n" +
         lead_section(results) + (first ? variants : "") + worth_section(results, looks) + "</header>\n" +
         (notes.baseline ? baseline_section(*notes.baseline, looks) : "") + case_links(results) +
         (looks.empty() ? "" : key_of(looks)) + cases + (first ? "" : variants) +
         "<section id=\"paper\"><h2>Beside the paper</h2>\n" + paper_section(results, notes) +
         "</section>\n" + (notes.stability ? stability_section(*notes.stability, looks) : "") +
         "<section id=\"origin\"><h2>Device and settings</h2>\n" + origin_section(results) +
         "</section>\n</main>\n" + "<script type=\"application/json\" id=\"data\">" + script_json(data) +
         "</script>\n";
}

using Scripts = std::vector<const EmbeddedFile*>;

/// What the page may do: show itself.
std::string policy(const Scripts& scripts) {
  std::string hashes;
  for (const EmbeddedFile* script : scripts) hashes += " " + csp_hash(script->sha256_hex);
  return "default-src 'none'; img-src data:; style-src " + csp_hash(report_files::page_css.sha256_hex) +
         "; script-src" + hashes + "; base-uri 'none'; form-action 'none'";
}

std::string title_of(const Results& results) {
  if (results.scenes.empty()) return "unghost";
  return "unghost: " + results.scenes.front().scene + " on " + results.scenes.front().device;
}

} // namespace

std::string report_page(const Results& results, const FindPicture& pictures, const PageNotes& notes) {
  Scripts scripts = {&report_files::page_js, &report_files::page_pictures_js};
  if (!report_files::chart_js.text.empty()) {
    scripts.push_back(&report_files::chart_js);
    scripts.push_back(&report_files::page_charts_js);
  }
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta "
      "http-equiv=\"Content-Security-Policy\" content=\"" +
      policy(scripts) + "\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
      "<meta name=\"color-scheme\" content=\"light dark\"><link rel=\"icon\" href=\"data:,\">\n<title>" +
      escaped(title_of(results)) + "</title>\n<style>" + std::string(report_files::page_css.text) +
      "</style></head>\n<body>\n" + body_of(results, pictures, notes);
  for (const EmbeddedFile* script : scripts) html += "<script>" + std::string(script->text) + "</script>\n";
  return html + "</body></html>\n";
}

} // namespace unghost
