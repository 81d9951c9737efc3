#include "app/sweep_plan.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <set>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/failure.h"
#include "app/fingerprint.h"
#include "app/measuring.h"
#include "app/paths.h"
#include "renderer/spelling.h"

namespace unghost {
namespace {

using nlohmann::json;

constexpr const char* program = "unghost";
constexpr const char* command = "measure";

const std::vector<std::string> members = {"scenes",   "rigs", "sizes",  "seeds",   "modes",
                                          "settings", "what", "frames", "protocol"};

[[noreturn]] void refuse(const std::string& why) { throw std::invalid_argument(why); }

void check_known(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  if (std::ranges::count(known, name) == 0)
    refuse("there is no " + what + " '" + name + "'" + did_you_mean(name, known));
}

/// A number, as the command line has it.
std::string number_of(const json& value, const std::string& member) {
  if (!value.is_number_integer()) refuse(member + " has " + value.dump() + ", which is no whole number");
  return value.dump();
}

/// A number or a word, as the command line has it.
std::string text_of(const json& value, const std::string& member) {
  if (value.is_string()) return value;
  if (!value.is_number()) refuse(member + " has " + value.dump() + ", which is neither a word nor a number");
  return value.dump();
}

/// name=value of each.
using Assignments = std::vector<std::string>;

/// A plan read, with the command's defaults where it has none: the lists that are multiplied, then what every
/// job has.
struct Plan {
  std::vector<std::string> scenes, rigs, sizes, seeds;
  std::vector<Assignments> settings{{}};
  std::vector<std::string> what{""}; // empty: the command's default
  std::string modes, frames, protocol;

  std::array<size_t, 6> counts() const {
    return {scenes.size(), rigs.size(), sizes.size(), seeds.size(), settings.size(), what.size()};
  }
};

const json& list_of(const json& plan, const std::string& member) {
  const json& list = plan.at(member);
  if (!list.is_array()) refuse(member + " is no list");
  if (list.empty()) refuse(member + " is empty; leave it out for the default");
  return list;
}

void read_texts(const json& plan, const std::string& member, std::vector<std::string>& into) {
  if (!plan.contains(member)) return;
  into.clear();
  for (const json& value : list_of(plan, member)) {
    into.push_back(text_of(value, member));
    if (into.back().empty()) refuse(member + " has an empty word");
  }
}

Assignments assignments_of(const json& object) {
  if (!object.is_object()) refuse("settings is a list of objects, name: value");
  Assignments assignments;
  for (const auto& [name, value] : object.items())
    assignments.push_back(name + "=" + text_of(value, "settings"));
  return assignments;
}

Plan defaults() {
  CommandLine line;
  line.command = &*std::ranges::find(commands(), command, &CommandRow::name);
  const Shot shot = shot_from(line);
  Plan plan;
  plan.scenes = {shot.scene}, plan.rigs = {shot.rig}, plan.sizes = {text_of(shot.size)},
  plan.seeds = {std::to_string(shot.seed)};
  return plan;
}

Plan plan_of(const json& object) {
  if (!object.is_object()) refuse("it is no JSON object");
  for (const auto& [member, value] : object.items()) check_known("member", member, members);
  Plan plan = defaults();
  read_texts(object, "scenes", plan.scenes), read_texts(object, "rigs", plan.rigs);
  read_texts(object, "sizes", plan.sizes), read_texts(object, "seeds", plan.seeds);
  read_texts(object, "what", plan.what);
  if (object.contains("settings")) {
    plan.settings.clear();
    for (const json& one : list_of(object, "settings")) plan.settings.push_back(assignments_of(one));
  }
  std::vector<std::string> modes;
  read_texts(object, "modes", modes);
  plan.modes = joined(modes, ",");
  if (object.contains("frames")) plan.frames = number_of(object.at("frames"), "frames");
  if (object.contains("protocol")) plan.protocol = text_of(object.at("protocol"), "protocol");
  return plan;
}

/// One combination; `at` has an index into each of the lists.
Words words_of(const Plan& plan, const std::array<size_t, 6>& at) {
  Words words = {command,  plan.scenes[at[0]], "--rig",  plan.rigs[at[1]],
                 "--size", plan.sizes[at[2]],  "--seed", plan.seeds[at[3]]};
  const auto add = [&words](const char* option, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {option, value});
  };
  add("--modes", plan.modes);
  add("--what", plan.what[at[5]]);
  add("--frames", plan.frames);
  add("--protocol", plan.protocol);
  for (const std::string& assignment : plan.settings[at[4]]) add("--set", assignment);
  return words;
}

void check_scene(const std::string& scene) {
  const DataFolders folders = find_data_folders();
  std::error_code ignored;
  if (std::filesystem::exists(scene_file(scene, folders.assets), ignored)) return;
  std::vector<std::string> known;
  for (const auto& entry : std::filesystem::directory_iterator(folders.assets))
    if (entry.path().extension() == ".glb") known.push_back(entry.path().stem().string());
  refuse("there is no scene '" + scene + "'" + did_you_mean(scene, known));
}

/// As the command itself would.
void check_words(const Words& words) {
  const CommandLine line = command_line_of(words);
  if (line.scene != words[1]) refuse("'" + words[1] + "' is no name of a scene");
  MeasurePlan{line};
}

/// Each value once, beside the first of the other lists.
void check(const Plan& plan) {
  for (const std::string& scene : plan.scenes) check_scene(scene);
  for (size_t list = 0; list < plan.counts().size(); ++list)
    for (size_t i = 0; i < plan.counts()[list]; ++i) {
      std::array<size_t, 6> at{};
      at[list] = i;
      check_words(words_of(plan, at));
    }
}

std::vector<Job> jobs_of(const Plan& plan) {
  size_t count = 1;
  for (const size_t of_list : plan.counts()) count = std::min(count * of_list, most_jobs + 1);
  if (count > most_jobs) refuse("it comes to more than " + std::to_string(most_jobs) + " jobs");
  std::vector<Job> jobs;
  std::set<std::string> names;
  for (size_t job = 0; job < count; ++job) {
    std::array<size_t, 6> at{};
    size_t rest = job;
    for (size_t list = at.size(); list-- > 0; rest /= plan.counts()[list])
      at[list] = rest % plan.counts()[list];
    Words words = words_of(plan, at);
    const std::string name = shard_name(words);
    if (!names.insert(name).second) refuse("it has twice: " + quoted_words(words));
    jobs.push_back({.words = std::move(words), .shard = name});
  }
  return jobs;
}

} // namespace

std::string shard_name(const Words& words) {
  std::string name;
  for (const size_t i : {1u, 3u, 5u, 7u}) {
    const std::string part = i == 1 ? std::filesystem::path(words[i]).stem().string() : words[i];
    name += part + "-";
  }
  for (char& c : name)
    if (std::string_view("-_.").find(c) == std::string_view::npos && !isalnum(static_cast<unsigned char>(c)))
      c = '-';
  Fingerprint fingerprint;
  for (const std::string& word : words) fingerprint.add(word);
  return name + fingerprint.hex(16) + ".json";
}

std::string line_of(const Job& job) {
  Words words = {program};
  words.insert(words.end(), job.words.begin(), job.words.end());
  words.insert(words.end(), {"-o", job.shard});
  return quoted_words(words);
}

Job job_of_line(std::string_view line) {
  Words words = words_of_line(line);
  if (words.size() < 2 || std::filesystem::path(words[0]).filename() != program || words[1] != command)
    refuse("it does not begin with '" + std::string(program) + " " + command + "'");
  words.erase(words.begin());
  AskedWords asked = apart_from_output(words);
  const std::string shard = std::filesystem::path(asked.output).filename().string();
  if (!shard.ends_with(".json")) refuse("it has no -o FILE.json");
  return {.words = std::move(asked.words), .shard = shard};
}

std::vector<Job> jobs_of_plan(const json& object, const std::string& where) {
  try {
    const Plan plan = plan_of(object);
    check(plan);
    return jobs_of(plan);
  } catch (const Failure& failure) {
    throw Failure(Exit::input_refused, where + ": " + failure.what());
  } catch (const std::invalid_argument& error) { // words, a setting, or what is said here
    throw Failure(Exit::input_refused, where + ": " + error.what());
  }
}

} // namespace unghost
