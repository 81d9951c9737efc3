// sweep, job and merge as commands; lists of jobs as shells and schedulers run them.
#include <algorithm>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "tests/app/child.h"
#include "tests/app/fake_measuring.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr const char* small_plan = R"({"rigs": ["drive", "pass"], "sizes": ["64x36"], "seeds": [1, 2],
  "modes": ["blend", "uncharted"], "what": ["ghosting"], "frames": 20})";

std::string list_of(const ScratchFolder& folder) {
  const Outcome list = outcome({"sweep", folder.file("plan.json", small_plan).string(), "--list"});
  EXPECT_EQ(list.exit, 0) << list.err;
  EXPECT_EQ(list.err, "");
  return list.out;
}

std::vector<std::string> lines_in(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void expect_refused(const Words& words, int exit, const std::string& said) {
  const Outcome refused = outcome(words);
  EXPECT_EQ(refused.exit, exit) << said << ": " << refused.err;
  EXPECT_EQ(refused.out, "");
  EXPECT_NE(refused.err.find(said), std::string::npos) << refused.err;
}

TEST(SweepCommand, ListsOneCommandALine) {
  const ScratchFolder folder;
  const std::vector<std::string> lines = lines_in(list_of(folder));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(lines[0].starts_with("unghost measure asphalt --rig drive --size 64x36 --seed 1 --modes "
                                   "blend,uncharted --what ghosting --frames 20 -o asphalt-drive-64x36-1-"))
      << lines[0];
  const Outcome listed = outcome({"sweep", (folder.path / "plan.json").string(), "--list", "--json"});
  const json jobs = json::parse(listed.out).at("jobs");
  ASSERT_EQ(jobs.size(), 4u);
  for (size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(jobs[i].at("line"), lines[i]);
    EXPECT_TRUE(lines[i].ends_with(" -o " + jobs[i].at("file").get<std::string>()));
  }
}

TEST(SweepCommand, WrongWordsAreTwoAndAWrongPlanIsThree) {
  const ScratchFolder folder;
  const std::string plan = folder.file("plan.json", small_plan).string();
  expect_refused({"sweep"}, 2, "wants a PLAN");
  expect_refused({"sweep", plan}, 2, "wants -o FOLDER");
  expect_refused({"sweep", plan, "-o", "-"}, 2, "wants -o FOLDER");
  expect_refused({"sweep", plan, "--list", "-o", "a"}, 2, "runs nothing");
  expect_refused({"sweep", plan, "--size", "4x4"}, 2, "--size");
  expect_refused({"sweep", "/nowhere.json", "--list"}, 3, "/nowhere.json");
  expect_refused({"sweep", folder.file("a.json", "{").string(), "--list"}, 3, "a.json is no JSON");
  expect_refused({"sweep", folder.file("b.json", R"({"rigs": ["drve"]})").string(), "-o", "s"}, 3,
                 "b.json: there is no rig 'drve'; did you mean 'drive'?");
}

TEST(JobCommand, WrongLinesAreRefused) {
  const ScratchFolder folder;
  const std::string jobs = folder.file("jobs.txt", "unghost measure -o a.json\nid; ls\n\nrm x").string();
  expect_refused({"job"}, 2, "wants JOBS");
  expect_refused({"job", jobs}, 2, "wants JOBS");
  expect_refused({"job", jobs, "1"}, 2, "wants -o FOLDER");
  expect_refused({"job", jobs, "0", "-o", "s"}, 2, "N: ");
  expect_refused({"job", jobs, "5", "-o", "s"}, 2, "has 4 lines; there is no line 5");
  expect_refused({"job", jobs, "2", "-o", "s"}, 3, "jobs.txt, line 2: it has ; outside quotes");
  expect_refused({"job", jobs, "3", "-o", "s"}, 3, "line 3: it does not begin with 'unghost measure'");
  expect_refused({"job", jobs, "4", "-o", "s"}, 3, "line 4: it does not begin with 'unghost measure'");
  expect_refused({"job", "/nowhere.txt", "1", "-o", "s"}, 3, "/nowhere.txt");
  expect_refused({"job", folder.file("empty.txt", "").string(), "1", "-o", "s"}, 2, "has 0 lines");
}

TEST(MergeCommand, JoinsWhatSawTheSameFrames) {
  const ScratchFolder folder;
  const fs::path shards = folder.path / "shards";
  const Words words = {"measure", "asphalt", "--rig", "drive", "--modes", "blend", "--what", "ghosting"};
  Words other = words;
  other.back() = "shimmer";
  fs::create_directory(shards);
  write_json(shards / "a.json", measured_json(fake_measured(words)));
  write_json(shards / "b.json", measured_json(fake_measured(other)));
  write_json(shards / "c.json", measured_json(fake_measured(
                                    words, {.version = "1", .build = "b", .device = "x", .driver = "y"})));
  folder.file("shards/notes.txt", "not JSON");
  const std::string output = (shards / "results.json").string();
  const Outcome merged = outcome({"merge", shards.string(), "-o", output});
  EXPECT_EQ(merged.exit, 0) << merged.err;
  EXPECT_EQ(merged.out, "");
  const std::string once = content_of(output);
  const Results results = results_from_json(json::parse(once), output);
  ASSERT_EQ(results.scenes.size(), 2u);
  EXPECT_EQ(results.protocol, "custom");
  const Measured& both = results.scenes[results.scenes[0].device == "none" ? 0 : 1];
  EXPECT_EQ(both.rows.at(0).figures.size(), 2u);
  EXPECT_TRUE(both.words.empty());
  const Outcome again = outcome({"merge", shards.string(), "-o", output, "--json"});
  EXPECT_EQ(json::parse(again.out).at("scenes"), 2); // and not itself among them
  EXPECT_EQ(content_of(output), once);
  EXPECT_EQ(outcome({"merge", output, "-o", "-"}).out, once); // results are as good as what they were made of
  const Outcome files =
      outcome({"merge", (shards / "c.json").string(), (shards / "b.json").string(),
               (shards / "a.json").string(), "-o", (folder.path / "r.json").string(), "--json"});
  EXPECT_EQ(json::parse(files.out).at("scenes"), 2);
  EXPECT_EQ(content_of(folder.path / "r.json"), once);
}

TEST(MergeCommand, SaysTheProtocolThatAllHad) {
  const ScratchFolder folder;
  const auto protocol_of = [&](const std::vector<std::string>& protocols) {
    Words merge = {"merge", "-o", "-"};
    for (const std::string& protocol : protocols) {
      Measured m = fake_measured({"measure", "--modes", "blend", "--what", "ghosting"});
      m.protocol = protocol;
      merge.push_back((folder.path / (std::to_string(merge.size()) + ".json")).string());
      write_json(merge.back(), measured_json(m));
    }
    const json results = json::parse(outcome(merge).out);
    EXPECT_EQ(results.at("scenes").size(), std::set(protocols.begin(), protocols.end()).size());
    return results.at("protocol").get<std::string>();
  };
  EXPECT_EQ(protocol_of({"full", "full"}), "full");
  EXPECT_EQ(protocol_of({"full", "quick"}), "custom");
}

TEST(MergeCommand, PicturesThatDoNotLieWithTheFiguresAreLeftOut) {
  const ScratchFolder folder;
  const fs::path shards = folder.path / "shards";
  fs::create_directory(shards);
  fs::create_directory_symlink(folder.path, shards / "link");
  Measured m = fake_measured({"measure", "--modes", "blend", "--what", "error"});
  for (const char* picture : {"/etc/passwd", "../1.png", "a/../../1.png", "link/1.png", ""})
    m.kept.push_back({.kind = "error", .mode = "blend", .picture = picture, .reference = "a/2.png"});
  m.kept.push_back({.kind = "error", .mode = "blend", .picture = "a/1.png", .reference = "../2.png"});
  write_json(shards / "a.json", measured_json(m));
  const Outcome merged = outcome({"merge", shards.string(), "-o", "-"});
  EXPECT_EQ(merged.exit, 0) << merged.err;
  EXPECT_TRUE(json::parse(merged.out).at("scenes").at(0).at("kept").empty()) << merged.out;
}

TEST(MergeCommand, WithoutSamplesTheFiguresStay) {
  const ScratchFolder folder;
  Measured m = fake_measured({"measure", "--modes", "blend", "--what", "ghosting"});
  m.kept = {{.kind = "ghosting",
             .mode = "blend",
             .frame = 1,
             .flip = .1,
             .picture = "a.png",
             .reference = "b.png"}};
  write_json(folder.path / "a.json", measured_json(m));
  const json results = json::parse(outcome({"merge", folder.path.string(), "--no-samples", "-o", "-"}).out);
  const json& row = results.at("scenes").at(0).at("rows").at(0);
  EXPECT_EQ(row.at("ghosting"), m.rows[0].figures.at("ghosting"));
  EXPECT_TRUE(row.at("samples").empty());
  EXPECT_TRUE(results.at("scenes").at(0).at("kept").empty());
}

TEST(MergeCommand, WhereJsonIsWrongIsSaid) {
  const ScratchFolder folder;
  expect_refused({"merge", folder.file("a.json", "{\"scenes\": [],\n \"version\" 1}").string(), "-o", "-"}, 3,
                 "no JSON: see line 2");
  expect_refused({"merge", folder.file("c.json", "{\"scenes\": \"x\n}").string(), "-o", "-"}, 3,
                 "see line 1");
  expect_refused({"merge", folder.file("d.json", "{\"scenes\": 1e999}").string(), "-o", "-"}, 3,
                 "out of range");
  expect_refused(
      {"merge", folder.file("b.json", R"({"scenes": [], "a": {"b": 1}, "scenes": []})").string(), "-o", "-"},
      3, "'scenes' twice in one object");
}

TEST(MergeCommand, ADeepFileIsRefused) {
  const ScratchFolder folder;
  const std::string deep = std::string(300'000, '[') + std::string(300'000, ']');
  const std::string file = folder.file("deep.json", R"({"settings": )" + deep + "}").string();
  expect_refused({"merge", file, "-o", "-"}, 3, "more than 64 deep");
}

TEST(MergeCommand, PicturesAreFoundFromTheResults) {
  const ScratchFolder folder;
  const fs::path shards = folder.path / "shards";
  fs::create_directory(shards);
  Measured m = fake_measured({"measure", "--modes", "blend", "--what", "error"});
  m.kept = {{.kind = "error", .mode = "blend", .picture = "a/1.png", .reference = "a/2.png"}};
  write_json(shards / "a.json", measured_json(m));
  const std::string output = (folder.path / "out.json").string();
  EXPECT_EQ(outcome({"merge", shards.string(), "-o", output}).exit, 0);
  const Results results = results_from_json(json::parse(content_of(output)), output);
  EXPECT_EQ(results.scenes.at(0).kept.at(0).picture, "shards/a/1.png");
  EXPECT_EQ(results.scenes.at(0).kept.at(0).reference, "shards/a/2.png");
}

TEST(MergeCommand, WhatCannotBeJoinedIsRefusedByName) {
  const ScratchFolder folder;
  const std::string out = (folder.path / "out").string();
  expect_refused({"merge"}, 2, "wants measurements");
  expect_refused({"merge", folder.path.string()}, 2, "wants -o");
  expect_refused({"merge", folder.path.string(), "-o", "-", "--json"}, 2, "--json");
  expect_refused({"merge", folder.path.string(), "-o", out}, 3, "no measurement in " + folder.path.string());
  expect_refused({"merge", "/nowhere", "-o", out}, 3, "/nowhere");
  for (const char* text : {"{", "{}", "[1]", R"({"scenes": [], "version": 9})"}) {
    const std::string shard = folder.file("bad.json", text).string();
    expect_refused({"merge", folder.path.string(), "-o", out}, 3, shard);
  }
  EXPECT_FALSE(fs::exists(out));
}

/// Whether a program of that name is installed.
bool there_is(const std::string& program) {
  const std::string path = std::getenv("PATH") == nullptr ? "" : std::getenv("PATH");
  std::istringstream folders(path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

/// A program of our name that comes first in PATH and writes its words to where -o says.
struct Writing {
  const ScratchFolder& folder;
  std::string path = std::getenv("PATH");

  explicit Writing(const ScratchFolder& scratch) : folder(scratch) {
    const fs::path script =
        folder.file("unghost", "#!/bin/sh\nfor last; do :; done\nprintf '%s\\0' \"$@\" > \"$last\"\n");
    fs::permissions(script, fs::perms::owner_all);
    setenv("PATH", (folder.path.string() + ":" + path).c_str(), 1);
  }
  ~Writing() { setenv("PATH", path.c_str(), 1); }
};

/// A list of jobs with names that a shell would take apart.
std::vector<Job> nasty_jobs(const ScratchFolder& folder) {
  fs::create_directory(folder.path / "scenes");
  json scenes = json::array();
  for (const char* name : {"a b", "it's", "$HOME", "{}", "{#} {.}", "*", "a;id", "\\n\"", "~", "grün"})
    scenes.push_back(folder.file("scenes/" + std::string(name) + ".glb", ""));
  return jobs_of_plan({{"scenes", scenes}, {"sizes", {"64x36"}}}, "plan.json");
}

void write_list(const ScratchFolder& folder, const std::vector<Job>& jobs) {
  std::string list;
  for (const Job& job : jobs) list += line_of(job) + "\n";
  folder.file("jobs.txt", list);
}

void expect_words_written(const ScratchFolder& folder, const std::vector<Job>& jobs) {
  for (const Job& job : jobs) {
    std::string expected;
    for (const std::string& word : job.words) expected += word + '\0';
    expected += std::string("-o") + '\0' + job.shard + '\0';
    EXPECT_EQ(content_of(folder.path / job.shard), expected) << line_of(job);
  }
}

TEST(JobList, AShellRunsItAsItIs) {
  const ScratchFolder folder;
  const Writing writing(folder);
  const std::vector<Job> jobs = nasty_jobs(folder);
  write_list(folder, jobs);
  EXPECT_EQ(exit_of({"sh", "jobs.txt"}, folder.path), 0);
  expect_words_written(folder, jobs);
}

TEST(JobList, GnuParallelRunsItAsItIs) {
  if (!there_is("parallel")) GTEST_SKIP() << "GNU parallel is not installed";
  const ScratchFolder folder;
  const Writing writing(folder);
  const std::vector<Job> jobs = nasty_jobs(folder);
  write_list(folder, jobs);
  setenv("PARALLEL_HOME", folder.path.c_str(), 1); // else it leaves a folder in the person's own
  EXPECT_EQ(exit_of({"sh", "-c", "parallel -j2 < jobs.txt"}, folder.path), 0);
  expect_words_written(folder, jobs);
}

TEST(JobList, SlurmRunsItsLinesAsAnArray) {
  if (!there_is("sbatch") || exit_of({"sh", "-c", "sinfo >/dev/null 2>&1"}) != 0)
    GTEST_SKIP() << "there is no Slurm that answers";
  const ScratchFolder folder;
  const Writing writing(folder);
  const std::string line = "unghost job jobs.txt $SLURM_ARRAY_TASK_ID -o line-$SLURM_ARRAY_TASK_ID";
  EXPECT_EQ(exit_of({"sbatch", "--wait", "--array=1-3", "--output=/dev/null", "--wrap", line}, folder.path),
            0);
  for (const char* number : {"1", "2", "3"}) {
    const std::string output = std::string("line-") + number;
    std::string expected;
    for (const std::string& word :
         {std::string("job"), std::string("jobs.txt"), std::string(number), std::string("-o"), output})
      expected += word + '\0';
    EXPECT_EQ(content_of(folder.path / output), expected);
  }
}

} // namespace
} // namespace unghost
