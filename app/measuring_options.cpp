#include "app/measuring_options.h"

#include "app/measure/baseline.h"
#include "app/measure/protocols.h"
#include "app/measure/stability/matrix.h"
#include "app/option_checks.h"
#include "renderer/spelling.h"

namespace unghost {
namespace {

template <class Row> std::vector<std::string> words_of(std::span<const Row> rows) {
  std::vector<std::string> words;
  for (const Row& row : rows) words.emplace_back(row.word);
  return words;
}

void add_figures(CLI::App& app, MeasureWords& measure) {
  app.add_option("--what", measure.what,
                 "Which figures, with commas: " + joined(words_of(aspects()), ", ") + " (default " +
                     words_by_default() + ")")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(no_option);
  app.add_option("--protocol", measure.protocol,
                 "quick (the default: 16 + 16 frames) or full (100 + 100, 1000 rounds)")
      ->check(CLI::IsMember(words_of(protocols())));
  app.add_option("--keep", measure.keep,
                 "Frames as PNG beside the .json file: none (the default), worst, or all that were judged")
      ->check(CLI::IsMember(words_of(keep_words())));
}

void add_report(CLI::App& app, CommandLine& line) {
  app.add_flag("--quick,!--no-quick", line.report.quick, "The quick protocol (the default): minutes");
  app.add_flag("--full,!--no-full", line.report.full,
               "The full protocol, at 1280x720 and 640x360: hours; goes on where it was ended");
  app.add_flag("--ablation,!--no-ablation", line.report.ablation,
               "Also unghost with each of its parts taken out: what it saves, and what it costs");
  app.add_option("--from", line.report.from,
                 "Measurements, files or folders, of which the page is written; nothing is measured")
      ->check(no_option);
  app.add_option("--stability", line.report.stability,
                 "What `unghost stability -o` wrote: the page then has that table, too")
      ->check(no_option);
  app.add_option("--baseline", line.report.baseline, "An older results.json: what is better, worse, or noise")
      ->check(no_option);
  add_number(app, "--allow", line.report.allow, 0, 100,
             "The share by which a figure may be worse than in the baseline (default " +
                 fixed(usual_allowance, 2) + ")");
  app.add_option("-o,--output", line.output, "The folder of the page; made where it is not there");
}

std::string case_names() {
  std::vector<std::string> names;
  for (const StabilityCase& row : stability_cases()) names.emplace_back(row.name);
  return joined(names, ", ");
}

void add_stability(CLI::App& app, CommandLine& line) {
  StabilityWords& stability = line.stability;
  app.add_option("--case", stability.cases, "Which cases, with commas (default all): " + case_names())
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(no_option);
  app.add_flag("--brief,!--no-brief", stability.brief, "As the tests run it: less of what takes long");
  app.add_flag("--long,!--no-long", stability.long_run,
               "100,000 frames of what has 5,000 or 10,000, and 50,000 trials by chance");
  app.add_option_function<std::string>(
      "--trial", [&stability](const std::string& text) { stability.trial = whole_number("a trial", text); },
      "Of --case chance, this one alone");
  app.add_option_function<std::string>(
      "--seed", [&line](const std::string& text) { line.seed = whole_number("a seed", text); },
      "Of what is by chance (default 1)");
}

void add_sweep(CLI::App& app, const CommandRow& row, CommandLine& line) {
  constexpr const char* folder = "The folder of the measurements; made where it is not there";
  if (row.options & sweep_plan) {
    app.add_option("PLAN", line.sweep.plan, "A JSON file of what to measure");
    app.add_flag("--list,!--no-list", line.sweep.list, "Print one command a line in place of running them");
    app.add_option("-o,--output", line.output, folder);
  }
  if (row.options & job_list) {
    app.add_option("JOBS", line.sweep.jobs, "What sweep --list printed");
    app.add_option("N", line.sweep.line, "Which line, from 1")->check(CLI::Range(1u, UINT32_MAX));
    app.add_option("-o,--output", line.output, folder);
  }
  if (row.options & shard_list) {
    app.add_option("SHARDS", line.sweep.shards, "Folders of measurements, and single files");
    app.add_flag_function(
        "--samples,!--no-samples", [&line](int64_t count) { line.sweep.samples = count > 0; },
        "With each frame and round, and the pictures' names (the default); without, figures alone: a small "
        "file, and no baseline");
    app.add_option("-o,--output", line.output, "The file of results; - is standard output");
  }
}

} // namespace

void add_measuring(CLI::App& app, const CommandRow& row, CommandLine& line) {
  if (row.options & figures) add_figures(app, line.measure);
  if (row.options & figures_out)
    app.add_option("-o,--output", line.output, "A .json file for all figures; - is standard output");
  if (row.options & report_choice) add_report(app, line);
  if (row.options & endurance) add_stability(app, line);
  add_sweep(app, row, line);
}

} // namespace unghost
