// A plan of a sweep, as the commands that it comes to; app/measure/RESULTS.md describes the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/words.h"

namespace unghost {

/// One measurement: a complete command.
struct Job {
  Words words;       // after the program's name, without -o
  std::string shard; // the name of the file that it writes

  bool operator==(const Job&) const = default;
};

/// For words that begin `measure SCENE --rig RIG --size SIZE --seed SEED`: short, of letters that every file
/// system has, and another for other words.
std::string shard_name(const Words& words);
/// `unghost measure ... -o SHARD`, as a shell reads it.
std::string line_of(const Job& job);
/// A line of a list of jobs. Throws std::invalid_argument with what is wrong: whatever is no measurement that
/// writes a file of JSON.
Job job_of_line(std::string_view line);

constexpr size_t most_jobs = 100'000;

/// Every combination of scene, rig, size, seed, settings and what to measure; the last of these changes
/// first. All modes are in each, as they see the same frames. Throws Failure(input_refused), which names
/// `where`, for whatever the command would refuse.
std::vector<Job> jobs_of_plan(const nlohmann::json& plan, const std::string& where);

} // namespace unghost
