// A sweep by processes of the program itself, and what is left of those that are ended.
#include <chrono>
#include <csignal>
#include <thread>

#include <gtest/gtest.h>

#include "tests/app/child.h"
#include "tests/app/outcome.h"
#include "tests/app/own_copy.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr const char* plan = R"({"rigs": ["drive"], "sizes": ["64x36"], "seeds": [1, 2],
  "modes": ["blend", "uncharted"], "what": ["ghosting"], "frames": 20})";

class SweepProgram : public testing::Test {
protected:
  void SetUp() override {
    folder_.file("plan.json", plan);
    folder_.file("jobs.txt", outcome({"sweep", at("plan.json"), "--list"}).out);
    EXPECT_EQ(exit_of(sweep("serial")), 0);
    EXPECT_EQ(count("serial"), 2u);
  }

  std::string at(const std::string& name) const { return (folder_.path / name).string(); }
  Words sweep(const std::string& shards) const {
    return {program_, "sweep", at("plan.json"), "-o", at(shards), "-q"};
  }
  Words job(const std::string& number) const {
    return {program_, "job", at("jobs.txt"), number, "-o", at("shared"), "-q"};
  }
  size_t count(const std::string& shards) const {
    std::error_code not_yet;
    return size_t(std::distance(fs::directory_iterator(at(shards), not_yet), fs::directory_iterator()));
  }
  std::string merged(const std::string& shards) const {
    const Outcome merge = outcome({"merge", at(shards), "-o", "-"});
    EXPECT_EQ(merge.exit, 0) << merge.err;
    return merge.out;
  }

  const ScratchFolder folder_;
  const std::string program_ = (folder_of_this_program() / "unghost").string();
};

TEST_F(SweepProgram, TwoWorkersOneKilledComeToTheSameBytes) {
  const pid_t killed = start(job("1")), other = start(job("2"));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  kill(killed, SIGKILL);
  EXPECT_EQ(wait_for(killed), 128 + SIGKILL);
  EXPECT_EQ(wait_for(other), 0);
  EXPECT_EQ(count("shared"), 1u); // and nothing half
  for (const char* number : {"1", "2"}) EXPECT_EQ(exit_of(job(number)), 0);
  EXPECT_EQ(merged("shared"), merged("serial"));
}

TEST_F(SweepProgram, AnInterruptLeavesWholeShardsThatASecondRunKeeps) {
  const pid_t interrupted = start(sweep("shared"));
  while (count("shared") == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(interrupted, SIGINT);
  EXPECT_EQ(wait_for(interrupted), 128 + SIGINT);
  EXPECT_EQ(count("shared"), 1u);
  const fs::path first = fs::directory_iterator(at("shared"))->path();
  EXPECT_EQ(content_of(first), content_of(folder_.path / "serial" / first.filename()));
  const auto written = fs::last_write_time(first);
  EXPECT_EQ(exit_of(sweep("shared")), 0);
  EXPECT_EQ(fs::last_write_time(first), written);
  EXPECT_EQ(merged("shared"), merged("serial"));
}

} // namespace
} // namespace unghost
