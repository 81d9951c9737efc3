#include "app/measure/results.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include "app/failure.h"

namespace unghost {
namespace {

using nlohmann::json;

json json_of(const Timing& timing) {
  return {{"host", timing.host},
          {"rig", timing.rig},
          {"rounds", timing.rounds},
          {"copy_ms", timing.copy_ms},
          {"motion_ms", timing.motion_ms}};
}

/// Every figure has its place, `null` where there is none.
json json_of(const MeasuredMode& row) {
  json object = {{"mode", row.mode}, {"samples", row.samples}};
  for (const FigureKind& kind : figure_kinds()) {
    const auto found = row.figures.find(std::string(kind.name));
    object[std::string(kind.name)] = found == row.figures.end() ? json() : json(found->second);
  }
  return object;
}

json json_of(const Convergence& convergence) {
  json object = {{"frames", convergence.frames}, {"curves", json::array()}};
  for (const ConvergenceCurve& curve : convergence.curves)
    object["curves"].push_back({{"kind", curve.kind}, {"name", curve.name}, {"error", curve.error}});
  return object;
}

json json_of(const KeptFrame& kept) {
  return {{"kind", kept.kind}, {"mode", kept.mode},       {"frame", kept.frame},
          {"flip", kept.flip}, {"picture", kept.picture}, {"reference", kept.reference}};
}

Timing timing_of(const json& object) {
  return {.host = object.at("host"),
          .rig = object.at("rig"),
          .rounds = object.at("rounds"),
          .copy_ms = object.at("copy_ms"),
          .motion_ms = object.at("motion_ms")};
}

std::map<std::string, double> figures_of(const json& object) {
  std::map<std::string, double> figures;
  for (const FigureKind& kind : figure_kinds()) {
    const auto found = object.find(kind.name);
    if (found != object.end() && !found->is_null()) figures[std::string(kind.name)] = found->get<double>();
  }
  return figures;
}

MeasuredMode row_of(const json& object) {
  return {.mode = object.at("mode"), .figures = figures_of(object), .samples = object.at("samples")};
}

Convergence convergence_of(const json& object) {
  Convergence convergence{.frames = object.at("frames"), .curves = {}};
  for (const json& curve : object.at("curves")) {
    convergence.curves.push_back(
        {.kind = curve.at("kind"), .name = curve.at("name"), .error = curve.at("error")});
    if (convergence.curves.back().error.size() != convergence.frames.size())
      throw std::invalid_argument("a curve has another number of points than there are frames");
  }
  return convergence;
}

KeptFrame kept_of(const json& object) {
  return {.kind = object.at("kind"),
          .mode = object.at("mode"),
          .frame = object.at("frame"),
          .flip = object.at("flip"),
          .picture = object.at("picture"),
          .reference = object.at("reference")};
}

Measured read_measured(const json& object) {
  Measured m{.version = object.at("version"),
             .build = object.at("build"),
             .device = object.at("device"),
             .driver = object.at("driver"),
             .software = object.at("software"),
             .validation = object.at("validation"),
             .debug_build = object.at("debug_build"),
             .scene = object.at("scene"),
             .rig = object.at("rig"),
             .seed = object.at("seed"),
             .frames = object.at("frames"),
             .fill = object.at("fill"),
             .samples = object.at("reference_samples"),
             .error_frames = object.at("error_frames"),
             .settings = object.at("settings"),
             .set = object.at("set"),
             .modes = {},
             .timing = {},
             .rows = {},
             .supersampled = {},
             .convergence = {},
             .kept = {}};
  const std::string size = object.at("size");
  const auto [x, error] = std::from_chars(size.data(), size.data() + size.size(), m.width);
  if (error != std::errc{} || x == size.data() + size.size() || *x != 'x' ||
      std::from_chars(x + 1, size.data() + size.size(), m.height).ptr != size.data() + size.size())
    throw std::invalid_argument("'" + size + "' is no size");
  for (const json& mode : object.at("modes")) m.modes.emplace_back(mode.at("name"), mode.at("settings"));
  if (!object.at("timing").is_null()) m.timing = timing_of(object.at("timing"));
  for (const json& row : object.at("rows")) m.rows.push_back(row_of(row));
  for (const json& one : object.at("supersampled"))
    m.supersampled.push_back({.samples = one.at("samples"), .figures = figures_of(one)});
  if (!object.at("convergence").is_null()) m.convergence = convergence_of(object.at("convergence"));
  for (const json& kept : object.at("kept")) m.kept.push_back(kept_of(kept));
  if (!std::ranges::equal(m.modes, m.rows, {}, &std::pair<std::string, json>::first, &MeasuredMode::mode))
    throw std::invalid_argument("its rows are not those of its modes");
  return m;
}

/// What must be alike for two to have seen the same frames, their modes aside.
json identity_of(const Measured& m) {
  return {m.scene, m.rig,    m.width,  m.height,  m.seed,       m.settings,   m.set,
          m.build, m.device, m.driver, m.version, m.validation, m.debug_build};
}

bool saw_the_same(const Measured& a, const Measured& b) {
  if (identity_of(a) != identity_of(b)) return false;
  return std::ranges::all_of(a.modes, [&](const auto& mode) {
    const auto other = std::ranges::find(b.modes, mode.first, &std::pair<std::string, json>::first);
    return other == b.modes.end() || other->second == mode.second;
  });
}

template <class Map> void join(Map& into, const Map& from) {
  for (const auto& [key, value] : from) into.insert_or_assign(key, value);
}

bool is_time(const std::string& figure) {
  static const std::set<std::string> times = {"added_ms", "p05", "p95", "over_copy", "over_naive"};
  return times.contains(figure);
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
  into.frames = std::max(into.frames, from.frames), into.fill = std::max(into.fill, from.fill);
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
  into.kept.insert(into.kept.end(), from.kept.begin(), from.kept.end());
}

void join_times(Measured& into, const Measured& from) {
  join_rows(into, from, true);
  into.timing = from.timing;
}

Measured without_figures(const Measured& of) {
  Measured bare = of;
  bare.timing.reset(), bare.convergence.reset();
  bare.modes.clear(), bare.rows.clear(), bare.supersampled.clear(), bare.kept.clear(),
      bare.error_frames.clear();
  return bare;
}

/// Those that saw the same frames: one entry, or one a host where there are times.
std::vector<Measured> joined(const std::vector<const Measured*>& alike) {
  std::map<std::string, Measured> by_host;
  for (const Measured* part : alike)
    if (part->timing)
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

std::span<const FigureKind> figure_kinds() {
  static constexpr FigureKind kinds[] = {
      {"ghosting", "ghosting", "mean FLIP", "Against the aliased frame, in motion, without jitter."},
      {"shimmer", "shimmer", "mean FLIP", "Between frames of a scene at rest, with jitter."},
      {"error", "error", "mean FLIP", "Against a supersampled frame, in motion, with jitter."},
      {"flicker", "flicker", "mean difference", "How much the error changes along the motion."},
      {"trail", "trail", "share", "Of the ghost that remains where a surface or its light changed.", 3},
      {"trail_surface", "trail, surfaces", "share", "Where another surface was.", 3},
      {"trail_shadow", "trail, shadows", "share", "Where the sun was seen otherwise.", 3},
      {"added_ms", "adds", "ms", "The time of all passes that `off` does not need, a median.", 2},
      {"p05", "5%", "ms", "Of the rounds were faster.", 2, false},
      {"p95", "95%", "ms", "Of the rounds were faster.", 2, false},
      {"over_copy", "over a copy", "", "The resolve over a full-screen copy in the same rounds.", 2},
      {"over_naive", "over naive", "", "The resolve over the plain resolve of the same row.", 3},
  };
  return kinds;
}

json measured_json(const Measured& m) {
  json object = {{"version", m.version},
                 {"build", m.build},
                 {"device", m.device},
                 {"driver", m.driver},
                 {"software", m.software},
                 {"validation", m.validation},
                 {"debug_build", m.debug_build},
                 {"scene", m.scene},
                 {"rig", m.rig},
                 {"size", std::to_string(m.width) + "x" + std::to_string(m.height)},
                 {"seed", m.seed},
                 {"frames", m.frames},
                 {"fill", m.fill},
                 {"reference_samples", m.samples},
                 {"error_frames", m.error_frames},
                 {"settings", m.settings},
                 {"set", m.set},
                 {"modes", json::array()},
                 {"timing", m.timing ? json_of(*m.timing) : json()},
                 {"rows", json::array()},
                 {"supersampled", json::array()},
                 {"convergence", m.convergence ? json_of(*m.convergence) : json()},
                 {"kept", json::array()}};
  for (const auto& [name, settings] : m.modes)
    object["modes"].push_back({{"name", name}, {"settings", settings}});
  for (const MeasuredMode& row : m.rows) object["rows"].push_back(json_of(row));
  for (const Supersampled& one : m.supersampled) {
    json& line = object["supersampled"].emplace_back(json{{"samples", one.samples}});
    line.update(one.figures);
  }
  for (const KeptFrame& kept : m.kept) object["kept"].push_back(json_of(kept));
  return object;
}

Measured measured_from_json(const json& object, const std::string& where) {
  try {
    return read_measured(object);
  } catch (const std::exception& error) { // a member is missing or of another type
    throw Failure(Exit::input_refused, where + " holds no measurement of unghost: " + error.what());
  }
}

json results_json(const Results& results) {
  json object = {{"version", results_format}, {"protocol", results.protocol}, {"scenes", json::array()}};
  for (const Measured& measured : results.scenes) object["scenes"].push_back(measured_json(measured));
  // of all, where they are alike
  const auto common = [&](const char* name) {
    const auto& scenes = object["scenes"];
    const bool alike = !scenes.empty() && std::ranges::all_of(scenes, [&](const json& scene) {
      return scene.at(name) == scenes.front().at(name);
    });
    object[name] = alike ? scenes.front().at(name) : json();
  };
  common("device"), common("settings");
  return object;
}

Results results_from_json(const json& object, const std::string& where) {
  const auto refuse = [&](const std::string& why) { throw Failure(Exit::input_refused, where + " " + why); };
  if (!object.is_object() || !object.contains("scenes") || !object.at("scenes").is_array() ||
      !object.contains("version"))
    refuse("holds no results of unghost");
  if (object.at("version") != results_format)
    refuse("has results of format " + object.at("version").dump() + "; this program reads " +
           std::to_string(results_format));
  Results results{.protocol = object.value("protocol", "custom"), .scenes = {}};
  for (const json& scene : object.at("scenes")) results.scenes.push_back(measured_from_json(scene, where));
  return results;
}

std::vector<Measured> merged(std::vector<Measured> parts) {
  const auto order = [](const Measured& m) {
    return std::tuple(m.scene, m.seed, m.width * uint64_t(m.height), m.rig, measured_json(m).dump());
  };
  std::ranges::sort(parts, {}, order);
  std::vector<std::vector<const Measured*>> groups;
  for (const Measured& part : parts) {
    const auto same = std::ranges::find_if(groups, [&](const auto& group) {
      return std::ranges::all_of(group, [&](const Measured* other) { return saw_the_same(part, *other); });
    });
    if (same == groups.end())
      groups.push_back({&part});
    else
      same->push_back(&part);
  }
  std::vector<Measured> entries;
  for (const auto& alike : groups)
    for (Measured& entry : joined(alike)) entries.push_back(std::move(entry));
  return entries;
}

} // namespace unghost
