// Measurements of many runs and machines, joined.
#include <algorithm>
#include <map>
#include <tuple>

#include "app/measure/results.h"

namespace unghost {
namespace {

using nlohmann::json;

/// What must be alike for two to have seen the same frames, their modes aside.
json identity_of(const Measured& m) {
  return {m.scene, m.rig,   m.width,  m.height, m.seed,    m.settings,   m.set,         m.protocol, m.frames,
          m.fill,  m.build, m.device, m.driver, m.version, m.validation, m.debug_build, m.inputs};
}

/// Modes of one name have the same settings.
bool go_together(const Measured& a, const Measured& b) {
  return std::ranges::all_of(a.modes, [&](const auto& mode) {
    const auto other = std::ranges::find(b.modes, mode.first, &std::pair<std::string, json>::first);
    return other == b.modes.end() || other->second == mode.second;
  });
}

template <class Map> void join(Map& into, const Map& from) {
  for (const auto& [key, value] : from) into.insert_or_assign(key, value);
}

bool is_time(const std::string& figure) {
  const auto kind = std::ranges::find(figure_kinds(), figure, &FigureKind::name);
  return kind != figure_kinds().end() && kind->time;
}

/// The times of `from`, or all but those.
MeasuredMode part_of(const MeasuredMode& from, bool times) {
  MeasuredMode part{.mode = from.mode, .figures = {}, .samples = {}};
  for (const auto& [name, value] : from.figures)
    if (is_time(name) == times) part.figures.emplace(name, value);
  for (const auto& [name, value] : from.samples)
    if (is_time(name) == times) part.samples.emplace(name, value);
  return part;
}

void join_rows(Measured& into, const Measured& from, bool times) {
  for (size_t i = 0; i < from.rows.size(); ++i) {
    const MeasuredMode part = part_of(from.rows[i], times);
    auto row = std::ranges::find(into.rows, part.mode, &MeasuredMode::mode);
    if (row == into.rows.end()) {
      into.modes.push_back(from.modes[i]);
      into.rows.push_back({.mode = part.mode, .figures = {}, .samples = {}});
      row = std::prev(into.rows.end());
    }
    join(row->figures, part.figures);
    join(row->samples, part.samples);
  }
}

/// All but the times.
void join_errors(Measured& into, const Measured& from) {
  join_rows(into, from, false);
  into.samples = std::max(into.samples, from.samples);
  if (into.error_frames.empty()) into.error_frames = from.error_frames;
  if (!into.convergence) into.convergence = from.convergence;
  for (const Supersampled& one : from.supersampled) {
    const auto same = std::ranges::find(into.supersampled, one.samples, &Supersampled::samples);
    if (same == into.supersampled.end())
      into.supersampled.push_back(one);
    else
      join(same->figures, one.figures);
  }
  for (const KeptFrame& kept : from.kept)
    if (std::ranges::count(into.kept, kept) == 0) into.kept.push_back(kept);
}

void join_times(Measured& into, const Measured& from) {
  join_rows(into, from, true);
  into.timing = from.timing;
}

/// What a mode adds hardly depends on the rig: one that was not timed takes the times of another of its
/// scene.
void lend_times(std::vector<Measured>& entries) {
  const auto elsewhere = [](const Measured& m) {
    json identity = identity_of(m);
    identity.erase(1); // the rig
    return identity;
  };
  std::vector<Measured> timed;
  std::ranges::copy_if(entries, std::back_inserter(timed),
                       [](const Measured& m) { return m.timing.has_value(); });
  for (Measured& entry : entries) {
    if (entry.timing) continue;
    const auto lender = std::ranges::find_if(timed, [&](const Measured& other) {
      return elsewhere(other) == elsewhere(entry) && std::ranges::equal(other.modes, entry.modes);
    });
    if (lender != timed.end()) join_times(entry, *lender);
  }
}

Measured without_figures(const Measured& of) {
  Measured bare = of;
  bare.timing.reset(), bare.convergence.reset(), bare.words.clear();
  bare.modes.clear(), bare.rows.clear(), bare.supersampled.clear(), bare.kept.clear(),
      bare.error_frames.clear();
  return bare;
}

/// Those that saw the same frames: one entry, or one a host where there are times.
std::vector<Measured> joined(const std::vector<const Measured*>& alike) {
  std::map<std::string, Measured> by_host;
  for (const bool own : {false, true}) // those that were lent by another rig give way
    for (const Measured* part : alike)
      if (part->timing && (part->timing->rig == part->rig) == own)
        join_times(by_host.try_emplace(part->timing->host, without_figures(*part)).first->second, *part);
  if (by_host.empty()) by_host.emplace("", without_figures(*alike.front()));
  std::vector<Measured> entries;
  for (auto& [host, entry] : by_host) {
    for (const Measured* part : alike) join_errors(entry, *part);
    entries.push_back(std::move(entry));
  }
  return entries;
}

} // namespace

std::vector<Measured> merged(std::vector<Measured> parts) {
  using Key = std::tuple<std::string, uint64_t, uint64_t, std::string, std::string, std::string>;
  // by what people look for first, large before small; the whole of it decides the rest
  std::map<Key, const Measured*> sorted;
  for (const Measured& m : parts)
    sorted.emplace(Key(m.scene, m.seed, UINT64_MAX - uint64_t(m.width) * m.height, m.rig,
                       identity_of(m).dump(), measured_json(m).dump()),
                   &m);
  std::vector<std::vector<const Measured*>> groups;
  std::map<std::string, std::vector<size_t>> of_identity; // into `groups`
  for (const auto& [key, part] : sorted) {
    std::vector<size_t>& candidates = of_identity[std::get<4>(key)];
    const auto fits = std::ranges::find_if(candidates, [&](size_t group) {
      return std::ranges::all_of(groups[group],
                                 [&](const Measured* other) { return go_together(*part, *other); });
    });
    if (fits == candidates.end()) {
      candidates.push_back(groups.size());
      groups.push_back({part});
    } else {
      groups[*fits].push_back(part);
    }
  }
  std::vector<Measured> entries;
  for (const auto& alike : groups)
    for (Measured& entry : joined(alike)) entries.push_back(std::move(entry));
  lend_times(entries);
  return entries;
}

} // namespace unghost
