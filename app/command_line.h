// The words after the program's name, as plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "app/words.h"
#include "renderer/frame_input.h"

namespace unghost {

struct CommandRow;

constexpr uint32_t most_frames = 1'000'000, longest_side = 16384;
constexpr uint32_t explain_rounds = 5; // some 40 s of the asphalt at 1280x720 on two cores of lavapipe

struct PictureSize {
  uint32_t width = FrameInput{}.width, height = FrameInput{}.height;

  bool operator==(const PictureSize&) const = default;
};

/// What `flip` is told.
struct FlipWords {
  std::optional<std::string> reference, test;
  std::optional<double> ppd, first_exposure, last_exposure;
  std::optional<uint32_t> exposures, rounds; // timed where rounds are given
  uint32_t threads = 0;                      // 0: as many as there are cores
  std::string tone_mapper = "aces";
};
constexpr uint32_t most_exposures = 100, most_flip_rounds = 10'000, most_threads = 256;

/// What `measure` is told.
struct MeasureWords {
  std::vector<std::string> what; // none: all but convergence and time
  std::string protocol = "quick", keep = "none";
};

/// What `report` is told.
struct ReportWords {
  bool quick = false, full = false;
  bool ablation = false;                          // unghost without each of its parts, too
  std::vector<std::string> from;                  // measurements, in place of measuring
  std::optional<std::string> baseline, stability; // files
  std::optional<double> allow;                    // share by which a figure may be worse
};

/// What `stability` is told.
struct StabilityWords {
  std::vector<std::string> cases; // none: all
  bool brief = false, long_run = false;
  std::optional<uint64_t> trial; // of what is by chance
};

/// What `sweep`, `job` and `merge` are told.
struct SweepWords {
  std::optional<std::string> plan, jobs;
  std::optional<uint32_t> line; // of `jobs`, from 1
  bool list = false;
  std::vector<std::string> shards; // files and folders
  bool samples = true;             // what figures are means and medians of goes with them
};

/// What was given; what was not is empty, and gets its default from the command.
struct CommandLine {
  const CommandRow* command = nullptr;
  Words words; // all of them, but for -o and its value
  std::optional<std::string> scene, mode, rig, view;
  std::vector<std::string> modes;
  std::vector<std::string> assignments; // `name=value`, in order; --view as the last
  std::filesystem::path settings, replay;
  std::optional<PictureSize> size;
  std::optional<uint32_t> frames, from, faces, rounds;
  std::optional<uint64_t> seed;
  std::optional<bool> crops;
  MeasureWords measure;
  std::string device; // index or part of a name; empty: the best
  bool validate = false, timings = false, json = false, quiet = false, verbose = false, of_scene = false,
       alone = false, watch = false;
  std::string output; // `-`: standard output
  std::filesystem::path sequence, buffers;
  FlipWords flip;
  SweepWords sweep;
  ReportWords report;
  StabilityWords stability;
};

/// The words were wrong; `what()` says which, and the nearest known one.
struct WrongWords : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// What --help and --version ask for in place of a run.
struct HelpText {
  std::string text;
};
struct VersionAsked {};

/// `WIDTHxHEIGHT`. Throws WrongWords.
PictureSize picture_size(const std::string& text);
/// A whole number from 0 that 64 bits hold. Throws WrongWords.
uint64_t whole_number(const char* what, const std::string& text);
/// `words` without the program's name. Throws WrongWords.
std::variant<CommandLine, HelpText, VersionAsked> parse_command_line(std::span<const char* const> words);
/// The same of words that ask for a command. Throws WrongWords.
CommandLine command_line_of(const Words& words);
/// What --help without a command prints.
std::string help_text();

} // namespace unghost
