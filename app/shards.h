// The files that jobs write: one measurement each, whole or not there.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/maker.h"
#include "app/measure/results.h"
#include "app/sweep_plan.h"

namespace unghost {

/// What runs the words of a command, and what they would be measured by.
struct Worker {
  std::function<void(const Words& words, Console& console)> run; // throws what ends it
  std::function<Maker(const Words& words)> maker;
};
/// This process.
Worker this_process();

/// Throws Failure(input_refused).
nlohmann::json read_json(const std::filesystem::path& file);
/// Whether `file` holds what `words` ask for as `maker` measures it, with all pictures that it names.
bool is_measured(const std::filesystem::path& file, const Words& words, const Maker& maker);

/// Makes the shard of `job` in `folder`, where it is not there yet; whether it had to. Throws Failure(failed)
/// where the words have run and it is still not there.
bool make_shard(const Job& job, const std::filesystem::path& folder, const Worker& worker, Console& console);

/// All measurements in files and folders, joined; not the file `but_for`, which is to be written. What
/// pictures they name is named as seen from the folder `seen_from`. Throws Failure(input_refused) where there
/// are none.
Results results_of(const std::vector<std::string>& names, const std::filesystem::path& seen_from,
                   const std::string& but_for = {});

struct Sweep {
  size_t measured = 0, skipped = 0;
  std::vector<std::string> failed; // shard: why
};
/// One after the other. A job that fails is noted, and the others go on; a signal or a device that is lost
/// ends all.
Sweep make_shards(const std::vector<Job>& jobs, const std::filesystem::path& folder, const Worker& worker,
                  Console& console);

} // namespace unghost
