#include "app/report_plan.h"

#include <algorithm>

#include "app/measure/report/ablation.h"
#include "app/measuring.h"
#include "app/rigs.h"
#include "renderer/mode_names.h"
#include "renderer/spelling.h"

namespace unghost {
namespace {

constexpr const char* timed_rig = "drive"; // what a mode adds hardly depends on the rig

/// The first is measured with all rigs; the second tells what depends on the size.
std::vector<PictureSize> sizes_of(const CommandLine& line) {
  if (line.size) return {*line.size};
  if (line.report.full) return {{1280, 720}, {640, 360}};
  return {{640, 360}, {320, 180}};
}

/// Those that a page can hold, all modes of a rig.
bool keeps_pictures(const CommandLine& line, PictureSize size) { return line.size || size.width == 640; }

std::vector<std::string> rigs_of(const CommandLine& line) {
  if (line.rig) return {*line.rig};
  std::vector<std::string> names;
  for (const Rig& rig : rigs()) names.emplace_back(rig.name);
  return names;
}

/// What --modes is told.
std::vector<std::string> modes_of(const CommandLine& line, bool jittered) {
  std::vector<std::string> modes = line.modes;
  if (!line.report.ablation) return modes;
  if (modes.empty()) modes.emplace_back("all");
  const auto add = [&](const std::string& name) {
    if (std::ranges::count(modes, name) == 0) modes.push_back(name);
  };
  if (std::ranges::count(modes, "all") == 0) add(std::string(ablated_row));
  for (const Part& part : parts())
    if (jittered || !changes_only_jitter(name_without(part))) add(name_without(part));
  return modes;
}

/// Of one scene, rig and size.
Job job_of(const CommandLine& line, const std::string& rig, PictureSize size, bool jittered,
           const Words& more) {
  Words words = {"measure", line.scene.value_or(own_scene),
                 "--rig",   rig,
                 "--size",  text_of(size),
                 "--seed",  std::to_string(line.seed.value_or(Shot{}.seed))};
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--modes", joined(modes_of(line, jittered), ","));
  for (const std::string& assignment : line.assignments) add("--set", assignment);
  add("--settings", line.settings.string());
  if (line.frames) add("--frames", std::to_string(*line.frames));
  add("--device", line.device);
  if (line.validate) words.push_back("--validate");
  add("--protocol", line.report.full ? "full" : "quick");
  words.insert(words.end(), more.begin(), more.end());
  return {.words = words, .shard = shard_name(words)};
}

} // namespace

std::vector<Job> report_jobs(const CommandLine& line) {
  std::vector<Job> jobs;
  for (const PictureSize size : sizes_of(line)) {
    const bool first = text_of(size) == text_of(sizes_of(line).front());
    for (const std::string& rig : rigs_of(line)) {
      if (!first && !line.report.full && rig != timed_rig && !line.rig) continue; // minutes
      std::string what = words_by_default();
      if (rig == rest_rig) what += ",convergence";
      jobs.push_back(job_of(line, rig, size, true,
                            {"--what", what, "--keep", keeps_pictures(line, size) ? "worst" : "none"}));
    }
    Words timed = {"--what", "time"};
    if (line.rounds) timed.insert(timed.end(), {"--rounds", std::to_string(*line.rounds)});
    jobs.push_back(job_of(line, line.rig.value_or(timed_rig), size, false, timed));
  }
  for (const Job& job : jobs)
    MeasurePlan{command_line_of(job.words)}; // refuses what is wrong before any work
  return jobs;
}

} // namespace unghost
