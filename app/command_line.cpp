#include "app/command_line.h"

#include <charconv>
#include <cstdlib>
#include <limits>

#include <CLI/CLI.hpp>

#include "app/commands.h"
#include "app/measure/flip.h"
#include "app/measuring_options.h"
#include "app/option_checks.h"
#include "app/paths.h"
#include "app/table.h"
#include "renderer/spelling.h"
#include "renderer/taa_modes.h"

namespace unghost {
namespace {

constexpr std::string_view footer =
    "Exit codes: 0 done; 1 failed, or over a bound; 2 the words were wrong; 3 the input was refused;\n"
    "4 no usable Vulkan device; 5 device lost or out of memory; 130 and 143 for signals.";

void add_talk(CLI::App& app, CommandLine& line) {
  app.add_flag("--json,!--no-json", line.json, "Figures as one JSON object on standard output");
  app.add_flag("-q,--quiet,!--no-quiet", line.quiet, "Say nothing but errors");
  app.add_flag("-v,--verbose,!--no-verbose", line.verbose, "Say more");
}

void add_device(CLI::App& app, CommandLine& line) {
  app.add_option("--device", line.device, "Index or part of the name of a Vulkan device")
      ->envname("UNGHOST_DEVICE");
  app.add_flag("--validate,!--no-validate", line.validate, "Switch on the Vulkan validation layer")
      ->envname("UNGHOST_VALIDATE");
}

void add_drawing(CLI::App& app, CommandLine& line, bool with_frames) {
  app.add_option("SCENE", line.scene, "A glTF file, or " + std::string(own_scene) + " (the default)");
  app.add_option("--set", line.assignments, "name=value, of any setting; may be repeated")
      ->allow_extra_args(false)
      ->check(no_option);
  app.add_option("--view", line.view, "What is drawn in place of the picture");
  app.add_option("--settings", line.settings, "JSON, or a PNG that unghost made: draws the same again");
  app.add_option("--rig", line.rig,
                 "How camera and vehicle move (default drive; measure: pass; report: all)");
  app.add_option_function<std::string>(
      "--size", [&line](const std::string& text) { line.size = picture_size(text); },
      "WIDTHxHEIGHT, in pixels (default 1280x720; report: two sizes)");
  if (with_frames)
    app.add_option(
           "--frames", line.frames,
           "Rendered one by one from a cold start; the last one counts (default 64; explain: 8; measure: "
           "the protocol's)")
        ->check(CLI::Range(1u, most_frames));
  app.add_option_function<std::string>(
      "--seed", [&line](const std::string& text) { line.seed = whole_number("a seed", text); },
      "Varies the rig; 1 is the rig as designed (default 1)");
  app.add_flag("--timings,!--no-timings", line.timings, "A table of passes: milliseconds and images");
  add_device(app, line);
}

void add_frames_out(CLI::App& app, CommandLine& line) {
  app.add_option("--sequence", line.sequence, "Write every frame to this folder, 00000.png on");
  app.add_option("--from", line.from, "The first frame that is written")->check(CLI::Range(0u, most_frames));
  app.add_option("--buffers", line.buffers,
                 "Write lit colour, depth, motion, tag and resolved as EXR to this folder");
}

void add_flip(CLI::App& app, FlipWords& flip) {
  app.add_option("REFERENCE", flip.reference, "PNG, OpenEXR or Radiance HDR; alpha is left out");
  app.add_option("TEST", flip.test, "Of the same size");
  add_number(app, "--ppd", flip.ppd, 1, 1000,
             "Pixels per degree of the viewer's eye (default 67.02: 0.7 m from 3840 pixels on 0.7 m)");
  add_number(app, "--first-exposure", flip.first_exposure, -60, 60, "HDR: in stops (default found)");
  add_number(app, "--last-exposure", flip.last_exposure, -60, 60, "HDR: in stops (default found)");
  app.add_option("--exposures", flip.exposures, "HDR: so many (default one a stop)")
      ->check(CLI::Range(2u, most_exposures));
  std::vector<std::string> mappers;
  for (const auto& [name, mapper] : tone_mappers) mappers.emplace_back(name);
  app.add_option("--tone-mapper", flip.tone_mapper, "HDR: aces (the default), hable or reinhard")
      ->check(CLI::IsMember(mappers));
  app.add_option("--rounds", flip.rounds, "Compute it so many times and say how long that takes")
      ->check(CLI::Range(1u, most_flip_rounds));
  app.add_option("--threads", flip.threads, "That share the work (default 0: as many as there are cores)")
      ->check(CLI::Range(0u, most_threads));
}

/// Which modes, or a path that has its own.
void add_modes(CLI::App& app, const CommandRow& row, CommandLine& line) {
  if (row.options & replayed)
    app.add_option("--replay", line.replay,
                   "A path that the demo recorded: scene, rig, sizes, settings and modes are its own; --set "
                   "and --view change them in all frames, and other modes can be named")
        ->check(no_option);
  if (row.options & one_mode)
    app.add_option("--mode", line.mode,
                   "Which temporal resolve (default " + std::string(default_taa_mode) +
                       "); rgb:alpha=0.05 is a row with a setting of its own");
  if (row.options & many_modes)
    app.add_option(
           "--modes", line.modes,
           "Names with commas between them, or all; rgb:alpha=0.05 is a row with a setting of its own, "
           "reject=tag+depth a list in it")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(no_option);
}

void add_rounds(CLI::App& app, const CommandRow& row, CommandLine& line) {
  if (row.options & (timed | figures))
    app.add_option("--rounds", line.rounds,
                   "Of all modes in turns, timed (default 31; the full protocol: 1000)")
        ->check(CLI::Range(1u, most_frames));
  if (row.options & anatomy)
    app.add_option("--rounds", line.rounds,
                   "Of the frame and of what it was made without, in turns (default " +
                       std::to_string(explain_rounds) + ")")
        ->check(CLI::Range(1u, most_frames));
}

void add_options(CLI::App& app, const CommandRow& row, CommandLine& line) {
  if (row.options & drawing) add_drawing(app, line, (row.options & rounds_only) == 0);
  if (row.options & device) add_device(app, line);
  add_modes(app, row, line);
  if (row.options & picture) app.add_option("-o,--output", line.output, "The picture; - is standard output");
  if (row.options & frames_out) add_frames_out(app, line);
  if (row.options & crops)
    app.add_flag_function(
        "--crops,!--no-crops", [&line](int64_t count) { line.crops = count > 0; },
        "Enlarge where the modes differ most");
  add_rounds(app, row, line);
  if (row.options & rounds_only)
    app.add_flag("--alone,!--no-alone", line.alone,
                 "Also draw each mode in frames of its own: all that it costs there, and what sharing the "
                 "geometry saves");
  if (row.options & watched)
    app.add_flag(
        "--watch,!--no-watch", line.watch,
        "Load the scene again when its files change, and compile the shaders again when their sources "
        "do, where the program was built (what they share with C++ wants the whole program built); "
        "what is broken is told, and the old goes on");
  if (row.options & axis_search) {
    app.add_option("--faces", line.faces, "Of the polytope, two an axis (default 16)")
        ->check(CLI::Range(4u, 64u));
    app.add_flag("--of-scene,!--no-of-scene", line.of_scene,
                 "For the scene's own aliased frames; else around the unit sphere, with X, Y and Z kept");
  }
  if (row.options & two_pictures) add_flip(app, line.flip);
  add_measuring(app, row, line);
  add_talk(app, line);
}

/// The grammar; `line` is filled while it parses.
std::unique_ptr<CLI::App> grammar(CommandLine& line, bool& version) {
  auto app = std::make_unique<CLI::App>("Shows and measures ghosting in temporal anti-aliasing.", "unghost");
  app->footer(std::string(footer));
  app->allow_extras();
  app->add_flag("--version", version, "Say the version of the program and of the driver");
  for (const CommandRow& row : commands()) {
    CLI::App* command = app->add_subcommand(std::string(row.name), std::string(row.summary));
    add_options(*command, row, line);
    command->callback([&line, &row] { line.command = &row; });
  }
  return app;
}

std::vector<std::string> known_words(const CLI::App& app, bool options) {
  std::vector<std::string> known;
  if (!options)
    for (const CommandRow& row : commands()) known.emplace_back(row.name);
  else
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
      for (const std::string& name : option->get_snames()) known.push_back("-" + name);
    }
  return known;
}

void refuse_unknown(const CLI::App& app, bool is_command) {
  const std::vector<std::string> unknown = app.remaining();
  if (unknown.empty()) return;
  const std::string& word = unknown.front();
  if (word.starts_with('-')) {
    const std::string name = word.substr(0, word.find('='));
    throw WrongWords("there is no option '" + name + "'" + did_you_mean(name, known_words(app, true)));
  }
  if (is_command) throw WrongWords("'" + word + "' is one word too many");
  throw WrongWords("there is no command '" + word + "'" + did_you_mean(word, known_words(app, false)));
}

/// `unghost car.glb` and `unghost --mode blend` mean the demo.
std::vector<std::string> with_command(std::span<const char* const> given) {
  std::vector<std::string> words(given.begin(), given.end());
  if (words.empty()) return words;
  const std::string& first = words.front();
  const bool of_program = first == "-h" || first == "--help" || first == "--version";
  if ((first.starts_with('-') && !of_program) || first.ends_with(".gltf") || first.ends_with(".glb"))
    words.insert(words.begin(), std::string(default_command));
  return words;
}

/// The library's "--size: 1 required TEXT missing" and "--size: At Most 1 required but received 2", in words.
std::string sentence_of(const CLI::ArgumentMismatch& error) {
  const std::string what = error.what(), option = what.substr(0, what.find(':'));
  return what.find("At Most") == std::string::npos ? option + " wants a value"
                                                   : option + " takes one value, and is given more";
}

} // namespace

PictureSize picture_size(const std::string& text) {
  PictureSize size;
  const char* end = text.data() + text.size();
  const auto [x, error] = std::from_chars(text.data(), end, size.width);
  const bool crossed = error == std::errc{} && x != end && *x == 'x';
  const bool whole = crossed && std::from_chars(x + 1, end, size.height).ptr == end && x + 1 != end;
  if (whole && size.width - 1 < longest_side && size.height - 1 < longest_side) return size;
  throw WrongWords("a size is WIDTHxHEIGHT, both from 1 to " + std::to_string(longest_side) + ", not '" +
                   text + "'");
}

uint64_t whole_number(const char* what, const std::string& text) {
  uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc{} && rest == end) return number;
  throw WrongWords(std::string(what) + " is a whole number from 0 to " +
                   std::to_string(std::numeric_limits<uint64_t>::max()) + ", not '" + text + "'");
}

std::variant<CommandLine, HelpText, VersionAsked> parse_command_line(std::span<const char* const> words) {
  CommandLine line{.words = apart_from_output(Words(words.begin(), words.end())).words};
  bool version = false;
  const char* validate = std::getenv("UNGHOST_VALIDATE");
  if (validate != nullptr && validate != std::string_view("0") && validate != std::string_view("1"))
    throw WrongWords("UNGHOST_VALIDATE is 0 or 1, not '" + std::string(validate) + "'");
  const std::unique_ptr<CLI::App> app = grammar(line, version);
  for (CLI::App* command : app->get_subcommands(nullptr)) command->allow_extras();
  try {
    std::vector<std::string> reversed = with_command(words);
    std::ranges::reverse(reversed);
    app->parse(std::move(reversed));
  } catch (const CLI::CallForHelp&) {
    return HelpText{app->help()};
  } catch (const CLI::ArgumentMismatch& error) {
    throw WrongWords(sentence_of(error));
  } catch (const CLI::ParseError& error) {
    throw WrongWords(error.what());
  }
  refuse_unknown(*app, false);
  for (const CLI::App* command : app->get_subcommands()) refuse_unknown(*command, true);
  if (version) return VersionAsked{};
  if (line.quiet && line.verbose) throw WrongWords("--quiet and --verbose do not go together");
  if (line.view) line.assignments.push_back("view=" + *line.view);
  return line;
}

CommandLine command_line_of(const Words& words) {
  std::vector<const char*> pointers;
  for (const std::string& word : words) pointers.push_back(word.c_str());
  auto parsed = parse_command_line(pointers);
  auto* line = std::get_if<CommandLine>(&parsed);
  if (line == nullptr || line->command == nullptr)
    throw WrongWords("'" + quoted_words(words) + "' is no command");
  return std::move(*line);
}

std::string help_text() {
  CommandLine line;
  bool version = false;
  return grammar(line, version)->help();
}

} // namespace unghost
