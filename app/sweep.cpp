// `unghost sweep`, `unghost job` and `unghost merge`: many measurements, in one process or on many machines.
#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "app/files.h"
#include "app/shards.h"

namespace unghost {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* standard_output = "-";
constexpr size_t largest_list = 256 << 20;

void check_folder(const CommandLine& line) {
  if (line.output.empty() || line.output == standard_output)
    throw WrongWords(std::string(line.command->name) + " wants -o FOLDER");
}

void list_jobs(const CommandLine& line, const std::vector<Job>& jobs, Console& console) {
  json object = {{"jobs", json::array()}};
  for (const Job& job : jobs) {
    object["jobs"].push_back({{"line", line_of(job)}, {"file", job.shard}});
    if (!line.json) console.out << line_of(job) << "\n";
  }
  if (line.json) console.out << object.dump(2) << "\n";
}

/// The text of line `number`, from 1.
std::string line_at(const std::string& file, uint32_t number) {
  const std::vector<uint8_t> bytes = read_file(file, largest_list);
  auto begin = bytes.begin();
  for (uint32_t at = 1; begin != bytes.end(); ++at) {
    const auto end = std::find(begin, bytes.end(), '\n');
    if (at == number) return {begin, end};
    if (end == bytes.end()) break;
    begin = std::next(end);
  }
  const auto lines = std::ranges::count(bytes, '\n') + (!bytes.empty() && bytes.back() != '\n');
  throw WrongWords(file + " has " + std::to_string(lines) + " lines; there is no line " +
                   std::to_string(number));
}

Job job_at(const std::string& file, uint32_t number) {
  const std::string text = line_at(file, number);
  try {
    return job_of_line(text);
  } catch (const std::invalid_argument& error) {
    throw Failure(Exit::input_refused, file + ", line " + std::to_string(number) + ": " + error.what());
  }
}

} // namespace

void sweep(const CommandLine& line, Console& console) {
  if (!line.sweep.plan) throw WrongWords("sweep wants a PLAN, a file of JSON");
  if (line.sweep.list && !line.output.empty())
    throw WrongWords("--list runs nothing, so that nothing is written to -o " + line.output);
  if (!line.sweep.list) check_folder(line);
  const std::vector<Job> jobs = jobs_of_plan(read_json(*line.sweep.plan), *line.sweep.plan);
  if (line.sweep.list) return list_jobs(line, jobs, console);
  std::ostream nowhere(nullptr); // tables of every job would say nothing together
  Console of_jobs{.out = nowhere,
                  .err = console.err,
                  .quiet = console.quiet,
                  .verbose = console.verbose,
                  .terminal = console.terminal};
  const Sweep done = make_shards(jobs, line.output, this_process(), of_jobs);
  if (line.json)
    console.out << json{{"folder", line.output},
                        {"jobs", jobs.size()},
                        {"measured", done.measured},
                        {"skipped", done.skipped},
                        {"failed", done.failed}}
                       .dump(2)
                << "\n";
  else if (!console.quiet)
    console.err << done.measured << " measured, " << done.skipped << " there before\n";
  if (!done.failed.empty())
    throw Failure(Exit::failed, std::to_string(done.failed.size()) + " of " + std::to_string(jobs.size()) +
                                    " jobs failed; the same command tries them again");
}

void job(const CommandLine& line, Console& console) {
  if (!line.sweep.jobs || !line.sweep.line) throw WrongWords("job wants JOBS, a file, and N, a line of it");
  check_folder(line);
  const Job asked = job_at(*line.sweep.jobs, *line.sweep.line);
  std::ostream nowhere(nullptr);
  Console of_job{.out = line.json ? nowhere : console.out,
                 .err = console.err,
                 .quiet = console.quiet,
                 .verbose = console.verbose,
                 .terminal = console.terminal};
  const bool measured = make_shard(asked, line.output, this_process(), of_job);
  const std::string file = (fs::path(line.output) / asked.shard).string();
  if (line.json)
    console.out << json{{"file", file}, {"skipped", !measured}}.dump(2) << "\n";
  else if (!measured && !console.quiet)
    console.err << file << " is there: skipped\n";
}

void merge(const CommandLine& line, Console& console) {
  if (line.sweep.shards.empty()) throw WrongWords("merge wants measurements: folders or files");
  if (line.output.empty()) throw WrongWords("merge wants -o FILE.json, or -o - for standard output");
  const bool to_out = line.output == standard_output;
  if (to_out && line.json) throw WrongWords("standard output has the results already; --json wants it, too");
  const fs::path seen_from = to_out ? fs::current_path() : fs::absolute(line.output).parent_path();
  Results results = results_of(line.sweep.shards, seen_from.lexically_normal(), line.output);
  if (!line.sweep.samples)
    for (Measured& measured : results.scenes) {
      measured.kept.clear(); // pictures would be looked for beside the file
      for (MeasuredMode& row : measured.rows) row.samples.clear();
    }
  const std::string text = results_json(results).dump(2) + "\n";
  if (to_out) {
    console.out << text;
    return;
  }
  write_file(line.output, bytes_of(text));
  if (line.json)
    console.out << json{{"file", line.output}, {"scenes", results.scenes.size()}}.dump(2) << "\n";
  else if (!console.quiet)
    console.err << results.scenes.size() << (results.scenes.size() == 1 ? " entry: " : " entries: ")
                << line.output << "\n";
}

} // namespace unghost
