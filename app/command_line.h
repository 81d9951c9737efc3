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

#include "renderer/frame_input.h"

namespace unghost {

struct CommandRow;

constexpr uint32_t most_frames = 1'000'000, longest_side = 16384;

struct PictureSize {
  uint32_t width = FrameInput{}.width, height = FrameInput{}.height;
};

/// What `flip` is told.
struct FlipWords {
  std::optional<std::string> reference, test;
  std::optional<double> ppd, first_exposure, last_exposure;
  std::optional<uint32_t> exposures;
  std::string tone_mapper = "aces";
};
constexpr uint32_t most_exposures = 100;

/// What was given; what was not is empty, and gets its default from the command.
struct CommandLine {
  const CommandRow* command = nullptr;
  std::optional<std::string> scene, mode, rig, view;
  std::vector<std::string> modes;
  std::vector<std::string> assignments; // `name=value`, in order; --view as the last
  std::filesystem::path settings;
  std::optional<PictureSize> size;
  std::optional<uint32_t> frames, from, faces;
  std::optional<uint64_t> seed;
  std::optional<bool> crops;
  std::vector<std::string> what;
  std::string device; // index or part of a name; empty: the best
  bool validate = false, timings = false, json = false, quiet = false, verbose = false, of_scene = false;
  std::string output; // `-`: standard output
  std::filesystem::path sequence, buffers;
  FlipWords flip;
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
uint64_t seed_of(const std::string& text);
/// `words` without the program's name. Throws WrongWords.
std::variant<CommandLine, HelpText, VersionAsked> parse_command_line(std::span<const char* const> words);
/// What --help without a command prints.
std::string help_text();

} // namespace unghost
