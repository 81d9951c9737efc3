#include <algorithm>
#include <cmath>
#include <set>

#include "app/measure/report/html.h"
#include "app/measure/report/sections.h"

namespace unghost {
namespace {

/// Items as a sentence has them.
std::string listed(const std::vector<std::string>& items) {
  std::string text;
  for (size_t i = 0; i < items.size(); ++i)
    text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
  return text;
}

struct Standing {
  std::string mode;
  size_t on_front = 0, best = 0, cheapest = 0; // in so many cases
};

/// Those of the front that are shown to have as little error as its last.
bool is_best(const Measured& m, const FigureKind& kind, const std::vector<size_t>& front, size_t i) {
  const auto shown = [&](size_t row) {
    return as_read(m.rows[row].figures.at(std::string(kind.name)), kind.decimals);
  };
  return shown(i) == shown(front.back());
}

/// Of modes on a front of this figure, those on most of them first.
std::vector<Standing> standings(const Results& results, const FigureKind& kind, size_t& cases) {
  std::vector<Standing> all;
  for (const Measured& m : results.scenes) {
    const std::vector<size_t> front = front_of(m, kind);
    cases += front.empty() ? 0 : 1;
    for (const size_t i : front) {
      auto found = std::ranges::find(all, m.rows[i].mode, &Standing::mode);
      if (found == all.end()) found = all.insert(all.end(), {m.rows[i].mode});
      ++found->on_front;
      found->best += is_best(m, kind, front, i) ? 1 : 0;
      found->cheapest += i == front.front() && front.size() > 1 ? 1 : 0;
    }
  }
  std::ranges::stable_sort(all, std::ranges::greater(),
                           [](const Standing& s) { return std::pair(s.on_front, s.best); });
  return all;
}

std::string figure_head(const FigureKind& kind) {
  return "<th scope=\"row\">" + escaped(kind.label) + "<small>" + escaped(kind.summary) + "</small></th>";
}

std::string times(size_t count, size_t of) {
  return of < 2 ? ""
                : " <span class=\"count\">" + std::to_string(count) + "/" + std::to_string(of) + "</span>";
}

std::string standings_row(const FigureKind& kind, const std::vector<Standing>& all, size_t cases,
                          const Looks& looks) {
  const size_t most = std::ranges::max_element(all, {}, &Standing::best)->best;
  std::string html = "<tr>" + figure_head(kind) + "<td class=\"winner\">";
  for (const Standing& one : all)
    if (one.best == most) html += "<div>" + mode_html(one.mode, looks) + times(most, cases) + "</div>";
  html += "</td><td><span class=\"chips\">";
  for (const Standing& one : all)
    html += "<span class=\"chip\">" + mode_html(one.mode, looks) + times(one.on_front, cases) +
            (one.cheapest == one.on_front && one.best == 0 ? " <small>cheapest</small>" : "") + "</span> ";
  return html + "</span></td></tr>\n";
}

std::string never_on_a_front(const Results& results, const std::set<std::string>& seen) {
  std::vector<std::string> never;
  for (const Measured& m : results.scenes)
    for (const MeasuredMode& row : m.rows)
      if (std::ranges::any_of(judged_by(),
                              [&](const FigureKind* kind) { return is_candidate(m, row, *kind); }) &&
          !seen.contains(row.mode) && std::ranges::find(never, row.mode) == never.end())
        never.push_back(row.mode);
  if (never.empty() || seen.empty()) return {};
  return "<p>Never worth it here, whatever is judged: " + escaped(listed(never)) + ".</p>\n";
}

constexpr std::string_view aliased_mode = "off";

/// Said where it is so: a reader would not expect it.
std::string aliased_is_nearest(const Measured& m) {
  const MeasuredMode *aliased = nullptr, *next = nullptr;
  const auto error = [](const MeasuredMode& row) { return as_read(row.figures.at("error"), 4); };
  for (const MeasuredMode& row : m.rows) {
    if (!row.figures.contains("error") || !std::isfinite(row.figures.at("error"))) continue;
    if (row.mode == aliased_mode)
      aliased = &row;
    else if (next == nullptr || error(row) < error(*next))
      next = &row;
  }
  if (aliased == nullptr || next == nullptr || error(*next) <= error(*aliased)) return {};
  return "<p class=\"note\">No mode is as near to the supersampled frame here as the aliased one: " +
         number(error(*aliased), 4) + "; the best of them, " + escaped(next->mode) + ", has " +
         number(error(*next), 4) + ". A weight of old frames costs more here than it mends.</p>\n";
}

std::string warnings(const Results& results) {
  std::vector<std::string> found;
  const auto warn = [&](bool Measured::*flag, const char* text) {
    if (std::ranges::any_of(results.scenes, flag)) found.emplace_back(text);
  };
  warn(&Measured::software,
       "The device is a processor (a software driver): its times are not those of a GPU.");
  warn(&Measured::validation, "The validation layers were on: times are longer than without.");
  warn(&Measured::debug_build, "The program was built for debugging: times are longer than of a release.");
  std::string html;
  for (const std::string& text : found) html += "<p class=\"warning\">" + text + "</p>\n";
  return html;
}

std::string measured_on(const Results& results) {
  std::vector<std::string> devices;
  for (const Measured& m : results.scenes) {
    const std::string device = m.device + (m.timing ? ", host " + m.timing->host : "");
    if (std::ranges::find(devices, device) == devices.end()) devices.push_back(device);
  }
  std::set<std::string> scenes, rigs, sizes;
  size_t modes = 0;
  for (const Measured& m : results.scenes) {
    scenes.insert(m.scene), rigs.insert(m.rig), sizes.insert(size_of(m));
    modes = std::max(modes, m.rows.size());
  }
  const auto list = [](const std::set<std::string>& set) {
    return escaped(listed({set.begin(), set.end()}));
  };
  return "<p class=\"lead\">" + std::to_string(modes) + (modes == 1 ? " mode" : " modes") + " on " +
         list(scenes) + (rigs.size() == 1 ? ", rig " : ", rigs ") + list(rigs) + ", at " + list(sizes) +
         ". Measured by unghost " + escaped(results.scenes.front().version) + " on " +
         escaped(listed(devices)) + ", protocol " + escaped(results.protocol) + ".</p>\n";
}

/// Size, and what else but scene and rig tells one from the others.
std::string apart(const Measured& m, const Results& among) {
  std::string name = size_of(m);
  const auto differ = [&](auto of) {
    return std::ranges::any_of(among.scenes, [&](const Measured& other) { return of(other) != of(m); });
  };
  if (differ([](const Measured& x) { return x.seed; })) name += ", seed " + std::to_string(m.seed);
  const auto host = [](const Measured& x) { return x.timing ? x.timing->host : std::string(); };
  if (differ(host) && m.timing) name += ", " + m.timing->host;
  if (differ([](const Measured& x) { return x.device; })) name += ", " + m.device;
  if (differ([](const Measured& x) { return x.build; })) name += ", " + m.build;
  if (differ([](const Measured& x) { return x.set; }))
    for (const std::string& set : m.set) name += ", " + set;
  return name;
}

} // namespace

std::string case_group(const Measured& m, const Results& among) { return m.scene + ", " + apart(m, among); }

std::string case_name(const Measured& m, const Results& among) {
  return m.scene + ", " + m.rig + ", " + apart(m, among);
}

std::string fronts_table(const Measured& m, const Looks& looks) {
  std::string html;
  for (const FigureKind* kind : errors_in(m)) {
    const std::vector<size_t> front = front_of(m, *kind);
    if (front.empty()) continue;
    html += "<tr>" + figure_head(*kind) + "<td><span class=\"chips\">";
    for (const size_t i : front) {
      const auto& figures = m.rows[i].figures;
      html += std::string("<span class=\"chip") + (is_best(m, *kind, front, i) ? " last" : "") + "\">" +
              mode_html(m.rows[i].mode, looks) + " <span class=\"count\">" +
              milliseconds(std::max(0., figures.at("added_ms"))) + " ms → " +
              number(figures.at(std::string(kind->name)), kind->decimals) + "</span></span> ";
    }
    html += "</span></td></tr>\n";
  }
  if (html.empty()) return aliased_is_nearest(m);
  const std::string lent = m.timing && m.timing->rig != m.rig ? "<p class=\"note\">Times are those of rig " +
                                                                    escaped(m.timing->rig) + ".</p>\n"
                                                              : "";
  return "<div class=\"wide\"><table class=\"fronts\"><thead><tr><th scope=\"col\">judged by</th><th "
         "scope=\"col\">worth having, "
         "from the cheapest to the best: what it adds → the figure</th></tr></thead><tbody>\n" +
         html + "</tbody></table></div>\n" + lent + aliased_is_nearest(m);
}

std::string lead_section(const Results& results) {
  if (results.scenes.empty()) return "<p class=\"lead\">Nothing was measured.</p>\n";
  return measured_on(results) + warnings(results);
}

std::string worth_section(const Results& results, const Looks& looks) {
  if (results.scenes.empty()) return {};
  std::string rows;
  std::set<std::string> seen;
  for (const FigureKind* kind : judged_by()) {
    size_t cases = 0;
    const std::vector<Standing> all = standings(results, *kind, cases);
    for (const Standing& one : all) seen.insert(one.mode);
    if (!all.empty()) rows += standings_row(*kind, all, cases, looks);
  }
  if (rows.empty())
    return "<p>No mode has both a time and an error, so nothing is said of what is worth it.</p>\n";
  const bool many = results.scenes.size() > 1;
  return "<h2 id=\"worth\">Worth having</h2><p>A mode is worth its time if no other is better and no "
         "dearer, or as good and cheaper: if it lies on the Pareto front" +
         std::string(many ? ", here with the number of rigs and sizes where it does" : "") +
         ". Times that the rounds do not tell apart, and figures that read alike, are equal.</p>\n<div "
         "class=\"wide\"><table class=\"fronts\"><thead><tr><th scope=\"col\">judged by</th><th "
         "scope=\"col\">best" +
         std::string(many ? ", most often" : "") +
         "</th><th scope=\"col\">on the front</th></tr></thead><tbody>\n" + rows +
         "</tbody></table></div>\n" + never_on_a_front(results, seen);
}

} // namespace unghost
