#include "app/shards.h"

#include <csignal>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/failure.h"
#include "app/interruption.h"
#include "renderer/gpu/device.h"
#include "tests/app/child.h"
#include "tests/app/fake_measuring.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

std::vector<Job> some_jobs() {
  return jobs_of_plan({{"rigs", {"still", "drive"}},
                       {"seeds", {1, 2, 3, 4, 5}},
                       {"sizes", {"64x36"}},
                       {"modes", {"blend", "uncharted"}},
                       {"what", {"ghosting", "shimmer"}}},
                      "plan.json");
}

struct Talk {
  std::ostringstream out, err;
  Console console{.out = out, .err = err};
};

std::string joined(const fs::path& folder) {
  const Outcome merged = outcome({"merge", folder.string(), "-o", "-"});
  EXPECT_EQ(merged.exit, 0) << merged.err;
  return merged.out;
}

TEST(Shards, OneIsMadeOnce) {
  const ScratchFolder folder;
  const Job job = some_jobs().front();
  Talk talk;
  const fs::path shards = folder.path / "made" / "shards";
  EXPECT_TRUE(make_shard(job, shards, fake_worker(), talk.console));
  const std::string first = content_of(shards / job.shard);
  EXPECT_EQ(measured_from_json(nlohmann::json::parse(first), "it").words, job.words);
  EXPECT_FALSE(make_shard(job, shards, fake_worker(), talk.console));
  EXPECT_EQ(content_of(shards / job.shard), first);
}

TEST(Shards, WhatIsNotWhatWasAskedForIsMadeAgain) {
  const ScratchFolder folder;
  const Job job = some_jobs().front();
  const fs::path file = folder.path / job.shard;
  Measured good = fake_measured(job.words);
  const auto valid = [&](const Measured& m) {
    write_json(file, measured_json(m));
    return is_measured(file, job.words, fake_maker);
  };
  EXPECT_FALSE(is_measured(file, job.words, fake_maker));
  EXPECT_TRUE(valid(good));
  for (std::string Measured::*member :
       {&Measured::version, &Measured::build, &Measured::device, &Measured::driver}) {
    Measured other = good;
    other.*member = "another";
    EXPECT_FALSE(valid(other));
  }
  Measured other_words = good;
  other_words.words.push_back("--json");
  EXPECT_FALSE(valid(other_words));
  for (const char* text : {"", "{", "[]", "{}", "null"}) {
    folder.file(job.shard, text);
    EXPECT_FALSE(is_measured(file, job.words, fake_maker)) << text;
  }
  good.kept = {{.kind = "error", .mode = "blend", .picture = "kept/a.png", .reference = "kept/b.png"}};
  EXPECT_FALSE(valid(good));
  fs::create_directory(folder.path / "kept");
  folder.file("kept/a.png", "a"), folder.file("kept/b.png", "b");
  EXPECT_TRUE(valid(good));
  folder.file(job.shard, "{");
  Talk talk;
  EXPECT_TRUE(make_shard(job, folder.path, fake_worker(), talk.console));
}

TEST(Shards, AJobThatLeavesNothingHasFailed) {
  const ScratchFolder folder;
  Talk talk;
  Worker idle = fake_worker();
  idle.run = [](const Words&, Console&) {};
  EXPECT_THROW(make_shard(some_jobs().front(), folder.path, idle, talk.console), Failure);
}

TEST(Shards, TheOthersGoOnWhereOneFails) {
  const ScratchFolder folder;
  const std::vector<Job> jobs = some_jobs();
  Talk talk;
  Worker failing = fake_worker();
  failing.run = [&](const Words& words, Console& console) {
    if (apart_from_output(words).words == jobs[1].words) throw Failure(Exit::input_refused, "no such scene");
    if (apart_from_output(words).words == jobs[2].words) throw GpuError(GpuFault::out_of_memory, "too large");
    fake_run(words, console);
  };
  const Sweep sweep = make_shards(jobs, folder.path, failing, talk.console);
  EXPECT_EQ(sweep.measured, jobs.size() - 2);
  EXPECT_EQ(sweep.failed,
            (std::vector<std::string>{jobs[1].shard + ": no such scene", jobs[2].shard + ": too large"}));
  EXPECT_EQ(folder.count(), jobs.size() - 2);
  const Sweep again = make_shards(jobs, folder.path, fake_worker(), talk.console);
  EXPECT_EQ(again.measured, 2u);
  EXPECT_EQ(again.skipped, jobs.size() - 2);
  EXPECT_TRUE(again.failed.empty());
}

TEST(Shards, AFolderThatTakesNothingEndsAllAtOnce) {
  const ScratchFolder folder;
  Talk talk;
  Worker worker = fake_worker();
  size_t begun = 0;
  const fs::path goes = folder.path / "shards";
  worker.run = [&](const Words&, Console&) {
    ++begun;
    fs::remove_all(goes); // as if the disk had gone
    throw Failure(Exit::failed, "cannot write");
  };
  EXPECT_THROW(make_shards(some_jobs(), goes, worker, talk.console), Failure);
  EXPECT_EQ(begun, 1u);
  EXPECT_THROW(make_shards(some_jobs(), folder.file("file", "") / "in", worker, talk.console), Failure);
  EXPECT_EQ(begun, 1u);
}

TEST(Shards, ALostDeviceAndASignalEndAllAndLeaveWholeShards) {
  const std::vector<Job> jobs = some_jobs();
  for (const bool signal : {false, true}) {
    const ScratchFolder folder;
    Talk talk;
    Worker ending = fake_worker();
    ending.run = [&](const Words& words, Console& console) {
      if (apart_from_output(words).words != jobs[3].words) return fake_run(words, console);
      const NewFile begun(apart_from_output(words).output);
      if (signal) throw Interrupted{SIGINT};
      throw GpuError(GpuFault::lost, "gone");
    };
    if (signal)
      EXPECT_THROW(make_shards(jobs, folder.path, ending, talk.console), Interrupted);
    else
      EXPECT_THROW(make_shards(jobs, folder.path, ending, talk.console), GpuError);
    EXPECT_EQ(folder.count(), 3u);
    EXPECT_EQ(make_shards(jobs, folder.path, fake_worker(), talk.console).skipped, 3u);
  }
}

TEST(Shards, ProgressIsForTerminals) {
  const std::vector<Job> jobs = some_jobs();
  const ScratchFolder folder;
  Talk pipe, quiet, terminal;
  quiet.console.terminal = terminal.console.terminal = true, quiet.console.quiet = true;
  for (Talk* talk : {&pipe, &quiet, &terminal}) make_shards(jobs, folder.path, fake_worker(), talk->console);
  EXPECT_EQ(pipe.err.str() + quiet.err.str(), "");
  EXPECT_NE(terminal.err.str().find("job 2 of 20: " + jobs[1].shard + "\n"), std::string::npos);
}

/// A worker in a process of its own, with every second job.
pid_t start_worker(const std::vector<Job>& jobs, size_t first, const fs::path& folder) {
  const pid_t child = fork();
  if (child != 0) return child;
  std::vector<Job> own;
  for (size_t i = first; i < jobs.size(); i += 2) own.push_back(jobs[i]);
  Talk talk;
  _exit(make_shards(own, folder, fake_worker(), talk.console).failed.empty() ? 0 : 1);
}

size_t files_in(const fs::path& folder) {
  std::error_code not_yet;
  return size_t(std::distance(fs::directory_iterator(folder, not_yet), fs::directory_iterator()));
}

TEST(Shards, TwoWorkersOneKilledComeToTheSameBytes) {
  const ScratchFolder folder;
  const fs::path serial = folder.path / "serial", shared = folder.path / "shared";
  const std::vector<Job> jobs = some_jobs();
  Talk talk;
  EXPECT_EQ(make_shards(jobs, serial, fake_worker(), talk.console).measured, jobs.size());

  const pid_t killed = start_worker(jobs, 0, shared), other = start_worker(jobs, 1, shared);
  while (files_in(shared) < 6) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(killed, SIGKILL);
  EXPECT_EQ(wait_for(killed), 128 + SIGKILL);
  EXPECT_EQ(wait_for(other), 0);
  const size_t left = files_in(shared);
  EXPECT_LT(left, jobs.size());
  for (const auto& file : fs::directory_iterator(shared))
    EXPECT_EQ(content_of(file), content_of(serial / file.path().filename()));

  EXPECT_EQ(wait_for(start_worker(jobs, 0, shared)), 0);
  EXPECT_EQ(files_in(shared), jobs.size());
  EXPECT_EQ(joined(shared), joined(serial));
}

} // namespace
} // namespace unghost
