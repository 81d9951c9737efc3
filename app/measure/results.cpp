#include "app/measure/results.h"

#include <algorithm>
#include <charconv>
#include <new>

#include "app/failure.h"

namespace unghost {
namespace {

using nlohmann::json;

json json_of(const Timing& timing) {
  return {{"host", timing.host},           {"rig", timing.rig},
          {"rounds", timing.rounds},       {"copy_ms", timing.copy_ms},
          {"motion_ms", timing.motion_ms}, {"geometry_ms", timing.geometry_ms}};
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
          .motion_ms = object.at("motion_ms"),
          .geometry_ms = object.at("geometry_ms")};
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

void read_size(const std::string& size, Measured& m) {
  const auto [x, error] = std::from_chars(size.data(), size.data() + size.size(), m.width);
  if (error != std::errc{} || x == size.data() + size.size() || *x != 'x' ||
      std::from_chars(x + 1, size.data() + size.size(), m.height).ptr != size.data() + size.size())
    throw std::invalid_argument("'" + size + "' is no size");
}

Measured read_measured(const json& object) {
  if (!object.is_object()) throw std::invalid_argument("it is no object");
  Measured m{.version = object.at("version"),
             .build = object.at("build"),
             .device = object.at("device"),
             .driver = object.at("driver"),
             .software = object.at("software"),
             .validation = object.at("validation"),
             .debug_build = object.at("debug_build"),
             .inputs = object.at("inputs"),
             .scene = object.at("scene"),
             .rig = object.at("rig"),
             .seed = object.at("seed"),
             .protocol = object.at("protocol"),
             .frames = object.at("frames"),
             .fill = object.at("fill"),
             .samples = object.at("reference_samples"),
             .error_frames = object.at("error_frames"),
             .settings = object.at("settings"),
             .set = object.at("set"),
             .words = object.at("words")};
  if (!m.settings.is_object()) throw std::invalid_argument("its settings are no object");
  read_size(object.at("size"), m);
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

} // namespace

std::span<const FigureKind> figure_kinds() {
  static constexpr FigureKind kinds[] = {
      {"ghosting", "ghosting", "mean FLIP", "Against the aliased frame, without jitter."},
      {"shimmer", "shimmer", "mean FLIP", "Between frames of a scene at rest, with jitter."},
      {"error", "error", "mean FLIP", "Against a supersampled frame, with jitter."},
      {"flicker", "flicker", "mean difference", "How much the error changes along the motion."},
      {"trail", "trail", "share", "Of the ghost that remains where a surface or its light changed.", 3},
      {"trail_surface", "trail, surfaces", "share", "Where another surface was.", 3},
      {"trail_shadow", "trail, shadows", "share", "Where the sun was seen otherwise.", 3},
      {"added_ms", "adds", "ms", "The time of all passes that `off` does not need, a median.", 2, true, true},
      {"added_over_copy", "adds, over a copy", "", "The same over a full-screen copy in the same rounds.", 2,
       true, true},
      {"p05", "adds, 5th percentile", "ms", "One round in 20 was faster.", 2, false, true},
      {"p95", "adds, 95th percentile", "ms", "One round in 20 was slower.", 2, false, true},
      {"over_copy", "resolve, over a copy", "", "The resolve over a full-screen copy in the same rounds.", 2,
       true, true},
      {"over_naive", "resolve, over naive", "", "The resolve over the plain resolve of the same row.", 3,
       true, true},
  };
  return kinds;
}

std::string size_of(const Measured& m) { return std::to_string(m.width) + "x" + std::to_string(m.height); }

json measured_json(const Measured& m) {
  json object = {{"version", m.version},
                 {"build", m.build},
                 {"device", m.device},
                 {"driver", m.driver},
                 {"software", m.software},
                 {"validation", m.validation},
                 {"debug_build", m.debug_build},
                 {"inputs", m.inputs},
                 {"scene", m.scene},
                 {"rig", m.rig},
                 {"size", size_of(m)},
                 {"seed", m.seed},
                 {"protocol", m.protocol},
                 {"frames", m.frames},
                 {"fill", m.fill},
                 {"reference_samples", m.samples},
                 {"error_frames", m.error_frames},
                 {"settings", m.settings},
                 {"set", m.set},
                 {"words", m.words},
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
  } catch (const std::bad_alloc&) {
    throw;                                // is no fault of the file
  } catch (const std::exception& error) { // a member is missing or of another type
    const std::string said = error.what();
    const size_t prefix =
        said.starts_with("[json.exception") ? said.find("] ") + 2 : 0; // the parser's own code
    throw Failure(Exit::input_refused, where + " holds no measurement of unghost: " + said.substr(prefix));
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
  if (!object.contains("protocol") || !object.at("protocol").is_string()) refuse("does not say its protocol");
  Results results{.protocol = object.at("protocol"), .scenes = {}};
  for (const json& scene : object.at("scenes")) results.scenes.push_back(measured_from_json(scene, where));
  return results;
}

} // namespace unghost
