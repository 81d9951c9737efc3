#include "app/shards.h"

#include <algorithm>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "app/files.h"
#include "app/interruption.h"
#include "app/shot.h"
#include "renderer/gpu/device.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr size_t largest_json = 256 << 20;

void run_here(const Words& words, Console& console) {
  const CommandLine line = command_line_of(words);
  Console own{.out = console.out,
              .err = console.err,
              .quiet = console.quiet || line.quiet,
              .verbose = console.verbose || line.verbose,
              .terminal = console.terminal,
              .progress = console.progress};
  line.command->run(line, own);
}

/// Whether a file that somebody's figures name is one that lies with them.
bool lies_beneath(const fs::path& folder, const std::string& name) {
  if (name.empty() || fs::path(name).is_absolute()) return false;
  const fs::path inside = fs::weakly_canonical(folder / name).lexically_relative(folder);
  return !inside.empty() && *inside.begin() != "..";
}

/// A measurement or results, with the pictures that they name as seen from `seen_from`; those that do not lie
/// beneath its folder are left out.
Results read_part(const fs::path& file, const fs::path& seen_from) {
  const nlohmann::json object = read_json(file);
  Results part;
  if (object.is_object() && object.contains("scenes")) {
    part = results_from_json(object, file.string());
  } else {
    part.scenes = {measured_from_json(object, file.string())};
    part.protocol = part.scenes.front().protocol;
  }
  const fs::path folder = fs::weakly_canonical(file).parent_path(), from = fs::weakly_canonical(seen_from);
  for (Measured& measured : part.scenes) {
    std::erase_if(measured.kept, [&](const KeptFrame& kept) {
      return !lies_beneath(folder, kept.picture) || !lies_beneath(folder, kept.reference);
    });
    for (KeptFrame& kept : measured.kept)
      for (std::string* picture : {&kept.picture, &kept.reference})
        *picture = (folder / *picture).lexically_relative(from).generic_string();
  }
  return part;
}

fs::directory_iterator entries_of(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator entries(folder, error);
  if (error) throw Failure(Exit::input_refused, "cannot read " + folder.string() + ": " + error.message());
  return entries;
}

/// Those named, and those in folders that are named; not the one that is to be written.
std::vector<fs::path> files_of(const std::vector<std::string>& names, const std::string& output) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const std::string& name : names)
    if (!fs::is_directory(name, error))
      files.emplace_back(name);
    else
      for (const auto& entry : entries_of(name))
        if (entry.path().extension() == ".json" && !fs::equivalent(entry.path(), output, error))
          files.push_back(entry.path());
  return files;
}

Results joined_results(const std::vector<fs::path>& files, const fs::path& seen_from) {
  Results results;
  for (const fs::path& file : files) {
    Results part = read_part(file, seen_from);
    if (results.scenes.empty())
      results.protocol = part.protocol;
    else if (results.protocol != part.protocol)
      results.protocol = "custom";
    std::ranges::move(part.scenes, std::back_inserter(results.scenes));
  }
  if (results.scenes.empty())
    throw Failure(Exit::input_refused, "there is no measurement in " + files.front().string());
  results.scenes = merged(std::move(results.scenes));
  return results;
}

/// Throws std::invalid_argument for JSON that is too deep for what reads it, or that names a member twice, of
/// which the parser would take the last without a word; and the parser's own parse_error.
nlohmann::json strict_json(const std::vector<uint8_t>& bytes) {
  using Event = nlohmann::json::parse_event_t;
  constexpr int deepest = 64;
  std::vector<std::set<std::string>> names; // of the objects that are open
  const auto check = [&names](int depth, Event event, nlohmann::json& parsed) {
    if (depth > deepest)
      throw std::invalid_argument("its JSON is more than " + std::to_string(deepest) + " deep");
    if (event == Event::object_start) names.emplace_back();
    if (event == Event::object_end) names.pop_back();
    if (event == Event::key && !names.back().insert(parsed.get<std::string>()).second)
      throw std::invalid_argument("it has '" + parsed.get<std::string>() + "' twice in one object");
    return true;
  };
  return nlohmann::json::parse(bytes, check);
}

/// Whether no other job could be done either.
bool ends_all(const GpuError& error) {
  return error.fault == GpuFault::lost || error.fault == GpuFault::no_device;
}

} // namespace

Worker this_process() {
  const auto known = std::make_shared<std::map<std::string, Maker>>(); // finding devices takes a while
  return {.run = run_here, .maker = [known](const Words& words) {
            const CommandLine line = command_line_of(words);
            auto found = known->find(line.device);
            if (found == known->end()) found = known->emplace(line.device, this_maker(line.device)).first;
            Maker maker = found->second;
            maker.inputs = inputs_of(shot_from(line).scene, line.settings);
            maker.validation = line.validate;
            return maker;
          }};
}

nlohmann::json read_json(const fs::path& file) {
  const std::vector<uint8_t> bytes = read_file(file, largest_json);
  try {
    return strict_json(bytes);
  } catch (const std::invalid_argument& error) {
    throw Failure(Exit::input_refused, file.string() + ": " + error.what());
  } catch (const nlohmann::json::parse_error& error) { // `byte` is the last that was read, from 1
    const auto read = ptrdiff_t(std::min(error.byte, bytes.size()));
    const auto line = 1 + std::count(bytes.begin(), bytes.begin() + std::max<ptrdiff_t>(read - 1, 0), '\n');
    throw Failure(Exit::input_refused, file.string() + " is no JSON: see line " + std::to_string(line));
  } catch (const nlohmann::json::exception&) { // a number that no double holds
    throw Failure(Exit::input_refused,
                  file.string() + " is no JSON that can be read: a number is out of range");
  }
}

Results results_of(const std::vector<std::string>& names, const fs::path& seen_from,
                   const std::string& but_for) {
  const std::vector<fs::path> files = files_of(names, but_for);
  if (files.empty())
    throw Failure(Exit::input_refused,
                  "there is no measurement in " + (names.empty() ? "nothing" : names.front()));
  return joined_results(files, seen_from);
}

bool is_measured(const fs::path& file, const Words& words, const Maker& maker) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return false;
  try {
    const Measured measured = measured_from_json(read_json(file), file.string());
    const Maker by{.version = measured.version,
                   .build = measured.build,
                   .device = measured.device,
                   .driver = measured.driver,
                   .inputs = measured.inputs,
                   .validation = measured.validation};
    return measured.words == words && by == maker &&
           std::ranges::all_of(measured.kept, [&](const auto& kept) {
             return fs::exists(file.parent_path() / kept.picture, ignored) &&
                    fs::exists(file.parent_path() / kept.reference, ignored);
           });
  } catch (const Failure&) { // half a file of another program's, a text: to be made again
    return false;
  }
}

bool make_shard(const Job& job, const fs::path& folder, const Worker& worker, Console& console) {
  const fs::path file = folder / job.shard;
  const Maker maker = worker.maker(job.words);
  if (is_measured(file, job.words, maker)) return false;
  make_folder(folder);
  Words words = job.words;
  words.insert(words.end(), {"-o", file.string()});
  worker.run(words, console);
  if (!is_measured(file, job.words, maker))
    throw Failure(Exit::failed, file.string() + " does not hold what it was to: " + quoted_words(job.words));
  return true;
}

Sweep make_shards(const std::vector<Job>& jobs, const fs::path& folder, const Worker& worker,
                  Console& console) {
  Sweep sweep;
  for (const Job& job : jobs) {
    throw_if_interrupted();
    if (console.terminal && !console.quiet)
      console.err << "job " << (&job - jobs.data() + 1) << " of " << jobs.size() << ": " << job.shard
                  << std::endl;
    try {
      ++(make_shard(job, folder, worker, console) ? sweep.measured : sweep.skipped);
      continue;
    } catch (const GpuError& error) {
      if (ends_all(error)) throw;
      sweep.failed.push_back(job.shard + ": " + error.what());
    } catch (const std::exception& error) { // an interruption is none
      sweep.failed.push_back(job.shard + ": " + error.what());
    }
    console.err << "unghost: " << sweep.failed.back() << std::endl;
    check_takes_files(folder); // or all the others would fail alike
  }
  return sweep;
}

} // namespace unghost
