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
  drawing = 1, // a scene, settings, a rig, a size, a device
  one_mode = 2,
  many_modes = 4,
  picture = 8,     // -o
  frames_out = 16, // sequences and buffers
  crops = 32,
  figures = 64, // what to measure, and how thoroughly
  device = 128,
  timed = 256,         // rounds
  rounds_only = 65536, // and no frames
  axis_search = 512,
  two_pictures = 1024,
  figures_out = 16384,   // -o of JSON
  report_choice = 32768, // how thoroughly, from what, beside what
  sweep_plan = 2048,
  job_list = 4096, // and which line of it
  shard_list = 8192,
};

struct CommandRow {
  std::string_view name, summary;
  unsigned options = 0;
  void (*run)(const CommandLine& line, Console& console) = nullptr;
};

std::span<const CommandRow> commands();

void capture(const CommandLine& line, Console& console);
void compare(const CommandLine& line, Console& console);
void measure(const CommandLine& line, Console& console);
void axes(const CommandLine& line, Console& console);
void flip_command(const CommandLine& line, Console& console);
void sweep(const CommandLine& line, Console& console);
void job(const CommandLine& line, Console& console);
void report(const CommandLine& line, Console& console);
void merge(const CommandLine& line, Console& console);
void bench(const CommandLine& line, Console& console);
void list_modes(const CommandLine& line, Console& console);
void list_rigs(const CommandLine& line, Console& console);
void list_views(const CommandLine& line, Console& console);
void list_settings(const CommandLine& line, Console& console);
void info(const CommandLine& line, Console& console);

} // namespace unghost
