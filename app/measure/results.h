// What was measured, as data: results.json is this and nothing else (app/measure/RESULTS.md describes it).
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace unghost {

/// The rig in which nothing moves.
constexpr const char* rest_rig = "still";

/// Of results.json. Another one is refused.
constexpr int results_format = 1;

/// One figure that modes are judged by; less is better.
struct FigureKind {
  std::string_view name, label, unit, summary;
  int decimals = 4;  // that are worth reading
  bool shown = true; // a column of tables for people
  bool time = false; // of one host, and never joined with another's
};
/// ghosting, shimmer, error, flicker, trail and its two parts, times.
std::span<const FigureKind> figure_kinds();

/// What was measured of one mode, by the figures' names. What was not measured, or is none, is absent.
struct MeasuredMode {
  std::string mode;
  std::map<std::string, double> figures;
  std::map<std::string, std::vector<double>>
      samples; // that a figure is the mean or median of: frames, rounds
};

/// Error against the number of frames: of a mode, of a jitter sequence in one mode, or of the mean of so many
/// samples.
struct ConvergenceCurve {
  std::string kind, name; // "mode", "jitter" or "supersampling"
  std::vector<double> error;
};
struct Convergence {
  std::vector<uint32_t> frames;
  std::vector<ConvergenceCurve> curves;
};

/// The mean of `samples` jittered frames: what a mode must beat. Each sample after the first adds the time of
/// the geometry (Timing::geometry_ms).
struct Supersampled {
  uint32_t samples = 1;
  std::map<std::string, double> figures; // those of MeasuredMode but the times
};

/// A frame that was kept for the eye. Files are PNG, relative to the folder of the shard.
struct KeptFrame {
  std::string
      kind; // "ghosting": without jitter, beside the aliased frame; "error": beside the supersampled one
  std::string mode;
  uint32_t frame = 0;
  double flip = 0; // mean
  std::string picture, reference;

  bool operator==(const KeptFrame&) const = default;
};

/// Where and when the run times were taken. They never mix with those of another machine.
struct Timing {
  std::string host, rig;
  uint32_t rounds = 0;
  double copy_ms = 0, motion_ms = 0, geometry_ms = 0; // medians; the last of G-buffer and light
};

/// One scene, rig and size; all modes saw the same frames.
struct Measured {
  std::string version, build, device, driver; // of the program that measured, and on what
  bool software = false, validation = false, debug_build = false;
  std::string inputs; // 16 digits of the bytes of the scene's file and of a file of settings
  std::string scene, rig;
  uint32_t width = 0, height = 0;
  uint64_t seed = 1;
  std::string protocol;               // quick, full, or custom where it was changed
  uint32_t frames = 0, fill = 0;      // drawn in all, of them before the first that counts
  uint32_t samples = 0;               // of a supersampled frame
  std::vector<uint32_t> error_frames; // of which there is a supersampled one
  nlohmann::json settings;            // shared by all modes
  std::vector<std::string> set;       // name=value, what was asked for beyond the defaults
  std::vector<std::string> words;     // of the command, without -o; none where several were joined
  std::vector<std::pair<std::string, nlohmann::json>> modes; // each mode's name and own settings
  std::optional<Timing> timing;
  std::vector<MeasuredMode> rows; // one a mode, in the order of `modes`
  std::vector<Supersampled> supersampled;
  std::optional<Convergence> convergence;
  std::vector<KeptFrame> kept;
};

/// Nothing moves, so there is nothing to ghost.
inline bool is_at_rest(const Measured& measured) { return measured.rig == rest_rig; }
/// "640x360"
std::string size_of(const Measured& measured);
nlohmann::json measured_json(const Measured& measured);
/// Throws Failure(input_refused) with what is wrong; `where` is the file.
Measured measured_from_json(const nlohmann::json& object, const std::string& where);

struct Results {
  std::string protocol; // quick, full or custom
  std::vector<Measured> scenes;
};

nlohmann::json results_json(const Results& results);
/// Of a file. Throws Failure(input_refused).
Results results_from_json(const nlohmann::json& object, const std::string& where);
/// A line a mode of each scene, rig and size; the first line names the columns.
std::string results_csv(const Results& results);

/// Joins what was measured of the same frames: figures of one scene, rig, size, seed, settings, program and
/// driver meet in one entry, each mode once, without words. Times are kept apart by host; errors go into the
/// entry of each. The order does not depend on the order of `parts`.
std::vector<Measured> merged(std::vector<Measured> parts);

} // namespace unghost
