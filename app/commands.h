// The commands there are, as rows: the grammar, --help and the dispatch iterate over them.
#pragma once

#include <ostream>
#include <span>
#include <string_view>

#include "app/command_line.h"

namespace unghost {

class Progress;

/// Where a run writes: data to `out`, talk to `err`.
struct Console {
  std::ostream& out;
  std::ostream& err;
  bool quiet = false, verbose = false;
  bool terminal = false;        // err is one: progress is shown
  Progress* progress = nullptr; // of a longer work, of which this is a part
};

/// What a command can be told, beyond --json and the talk.
enum CommandOptions : unsigned {
  drawing = 1u << 0, // a scene, settings, a rig, a size, a device
  one_mode = 1u << 1,
  many_modes = 1u << 2,
  picture = 1u << 3,    // -o
  frames_out = 1u << 4, // sequences and buffers
  crops = 1u << 5,
  figures = 1u << 6, // what to measure, and how thoroughly
  device = 1u << 7,
  timed = 1u << 8,       // rounds
  rounds_only = 1u << 9, // and no frames
  axis_search = 1u << 10,
  two_pictures = 1u << 11,
  figures_out = 1u << 12,   // -o of JSON
  report_choice = 1u << 13, // how thoroughly, from what, beside what
  sweep_plan = 1u << 14,
  job_list = 1u << 15, // and which line of it
  shard_list = 1u << 16,
  endurance = 1u << 17, // which cases of stability, and for how long
  anatomy = 1u << 18,   // of one frame
  watched = 1u << 19,   // files may change meanwhile
  replayed = 1u << 20,  // frames that the demo recorded
};

struct CommandRow {
  std::string_view name, summary;
  unsigned options = 0;
  void (*run)(const CommandLine& line, Console& console) = nullptr;
};

std::span<const CommandRow> commands();
/// What words without a command mean.
constexpr std::string_view default_command = "demo";

void demo(const CommandLine& line, Console& console);
void capture(const CommandLine& line, Console& console);
void compare(const CommandLine& line, Console& console);
void measure(const CommandLine& line, Console& console);
void axes(const CommandLine& line, Console& console);
void flip_command(const CommandLine& line, Console& console);
void sweep(const CommandLine& line, Console& console);
void job(const CommandLine& line, Console& console);
void report(const CommandLine& line, Console& console);
void stability(const CommandLine& line, Console& console);
void merge(const CommandLine& line, Console& console);
void bench(const CommandLine& line, Console& console);
void explain(const CommandLine& line, Console& console);
void list_modes(const CommandLine& line, Console& console);
void list_rigs(const CommandLine& line, Console& console);
void list_keys(const CommandLine& line, Console& console);
void list_views(const CommandLine& line, Console& console);
void list_settings(const CommandLine& line, Console& console);
void info(const CommandLine& line, Console& console);

} // namespace unghost
