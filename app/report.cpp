// `unghost report`: every measurement of a scene, and one page of them.
#include <algorithm>
#include <deque>
#include <iterator>
#include <new>

#include <nlohmann/json.hpp>

#include "app/baseline_table.h"
#include "app/failure.h"
#include "app/files.h"
#include "app/interruption.h"
#include "app/measure/baseline.h"
#include "app/measure/report/report_page.h"
#include "app/measuring.h"
#include "app/png_file.h"
#include "app/progress.h"
#include "app/report_notes.h"
#include "app/report_plan.h"
#include "app/shards.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

void check_words(const CommandLine& line) {
  if (line.output.empty() || line.output == "-") throw WrongWords("report wants -o FOLDER");
  if (line.report.quick && line.report.full) throw WrongWords("--quick and --full do not go together");
  if (line.report.allow && !line.report.baseline)
    throw WrongWords("--allow says how much worse than --baseline is no regression, and there is none");
  const bool chosen = line.report.quick || line.report.full || line.report.ablation || line.scene ||
                      line.rig || line.size || line.seed || line.frames || line.rounds ||
                      !line.modes.empty() || !line.assignments.empty() || !line.settings.empty();
  if (!line.report.from.empty() && chosen)
    throw WrongWords("--from reads what was measured, so that there is nothing to choose");
}

/// Measures what is not in the folder yet.
void measure_all_of(const std::vector<Job>& jobs, const fs::path& folder, Console& console) {
  std::ostream nowhere(nullptr); // a table a job would say nothing
  Console of_jobs{.out = nowhere, .err = console.err, .quiet = true, .verbose = false, .terminal = false};
  double work = 0;
  std::vector<double> works;
  for (const Job& job : jobs) work += works.emplace_back(work_of(MeasurePlan(command_line_of(job.words))));
  Progress progress(console, work);
  of_jobs.progress = &progress;
  const Worker worker = this_process();
  for (size_t i = 0; i < jobs.size(); ++i) {
    const Job& job = jobs[i];
    const double before = progress.done();
    progress.name(job.shard.substr(0, job.shard.rfind('-')));
    if (make_shard(job, folder, worker, of_jobs))
      progress.skip(works[i] - (progress.done() - before)); // an estimate: what it took is known now
    else
      progress.skip(works[i]);
  }
}

/// Nothing is decoded that is larger than `side`.
std::optional<Image> find_picture(const fs::path& folder, const std::string& file, uint32_t side) {
  throw_if_interrupted();
  const fs::path path = folder / file;
  std::error_code ignored;
  if (file.empty() || !fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    return decode_png(read_file(path, size_t(1) << 30), side);
  } catch (const std::bad_alloc&) {
    throw; // is no fault of the file
  } catch (const std::exception& error) {
    throw Failure(Exit::input_refused, path.string() + ": " + error.what());
  }
}

/// What `line` asks for: measured, or read.
Results results_for(const CommandLine& line, const std::vector<Job>& jobs, const fs::path& folder,
                    Console& console) {
  if (!line.report.from.empty())
    return results_of(line.report.from, folder, (folder / "results.json").string());
  const fs::path shards = folder / "measured";
  measure_all_of(jobs, shards, console);
  std::vector<std::string> files;
  for (const Job& job : jobs) files.push_back((shards / job.shard).string());
  return results_of(files, folder);
}

Baseline compared(const CommandLine& line, const Results& baseline, const Results& results) {
  const std::string file = *line.report.baseline;
  Baseline compared{file, compared_with(baseline, results, line.report.allow.value_or(usual_allowance))};
  if (compared.comparison.changes.empty()) // a check that passes because nothing was checked is none
    throw Failure(Exit::input_refused,
                  file +
                      " has nothing to compare these results with: no figure of the same scene, rig, size, "
                      "seed and settings with its samples");
  return compared;
}

void say_what_changed(const CommandLine& line, const Baseline& baseline, Console& console) {
  const BaselineComparison& comparison = baseline.comparison;
  console.out << (line.json ? comparison_json(comparison).dump(2) + "\n" : comparison_text(comparison));
  if (const size_t count = regressions(comparison); count > 0) {
    console.out.flush();
    throw Failure(Exit::failed, std::to_string(count) + (count == 1 ? " figure is" : " figures are") +
                                    " worse than in " + baseline.file + " by more than is allowed");
  }
}

/// None takes its place before all are written: a disk that fills up leaves the old ones, which go together.
void write_together(const std::vector<std::pair<fs::path, std::string>>& texts) {
  std::deque<NewFile> files;
  for (const auto& [path, text] : texts) files.emplace_back(path).write(bytes_of(text));
  for (NewFile& file : files) file.commit();
}

} // namespace

void report(const CommandLine& line, Console& console) {
  check_words(line);
  const fs::path folder = line.output;
  std::optional<Results> baseline; // before the work, which may write over it
  if (line.report.baseline)
    baseline = results_from_json(read_json(*line.report.baseline), *line.report.baseline);
  std::optional<StabilityTable> stability;
  if (line.report.stability)
    stability = stability_from_json(read_json(*line.report.stability), *line.report.stability);
  const std::vector<Job> jobs = line.report.from.empty() ? report_jobs(line) : std::vector<Job>{};
  make_folder(folder);
  const Results results = results_for(line, jobs, fs::absolute(folder).lexically_normal(), console);
  uint32_t side = 1;
  for (const Measured& measured : results.scenes) side = std::max({side, measured.width, measured.height});
  const auto find = [&](const KeptFrame&, const std::string& file) {
    return find_picture(folder, file, side);
  };
  PageNotes notes = report_notes(results);
  notes.stability = std::move(stability);
  if (baseline) notes.baseline = compared(line, *baseline, results);
  const std::string page = report_page(results, find, notes); // throws where a picture is broken
  write_together({{folder / "results.json", results_json(results).dump(1) + "\n"},
                  {folder / "results.csv", results_csv(results)},
                  {folder / "index.html", page}});
  if (notes.baseline) return say_what_changed(line, *notes.baseline, console);
  if (line.json)
    console.out << nlohmann::json{{"file", (folder / "index.html").string()},
                                  {"results", (folder / "results.json").string()},
                                  {"scenes", results.scenes.size()}}
                       .dump(2)
                << "\n";
  else if (!console.quiet)
    console.err << (folder / "index.html").string() << "\n";
}

} // namespace unghost
