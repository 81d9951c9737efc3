// Processes that are killed while they write, and two that write the same.
#include <chrono>
#include <csignal>
#include <thread>

#include "tests/program/program.h"

namespace unghost {
namespace {

class Killed : public ProgramTest {
protected:
  pid_t begin(const Words& words) const {
    return start(unvalidated + Words{program()} + words, folder_.path, talk_.path / "talk");
  }
};

TEST_F(Killed, LeavesTheWholeOldFileOrTheWholeNewOne) {
  const std::string other = undisturbed(small_capture, "a.png");
  const Words words = {"capture", "--size", "64x36", "--frames", "4", "--seed", "2", "-q", "-o", at("a.png")};
  ASSERT_EQ(run(words).exit, 0);
  const std::string whole = content_of(at("a.png"));
  ASSERT_NE(whole, other);
  const auto began = std::chrono::steady_clock::now();
  ASSERT_EQ(run(words).exit, 0);
  const auto takes = std::chrono::steady_clock::now() - began;
  for (const int share : {5, 9, 10}) { // tenths of how long it takes
    folder_.file("a.png", other);
    const pid_t child = begin(words);
    std::this_thread::sleep_for(takes * share / 10);
    kill(child, SIGKILL);
    wait_for(child);
    const std::string left = content_of(at("a.png"));
    EXPECT_TRUE(left == other || left == whole) << share << ": " << left.size() << " bytes";
  }
  EXPECT_EQ(run(words).exit, 0);
  EXPECT_EQ(content_of(at("a.png")), whole);
  EXPECT_EQ(folder_.count(), 1u) << "what a killed one left is gone";
}

TEST_F(Killed, AndTwoThatWriteTheSameLeaveOneOfTheirFiles) {
  const auto words = [this](const char* seed) {
    return Words{"capture", "--size", "64x36", "--frames", "3", "--seed", seed, "-q", "-o"};
  };
  const std::string one = undisturbed(words("1"), "a.png"), two = undisturbed(words("2"), "a.png");
  const pid_t first = begin(words("1") + Words{at("a.png")}), second = begin(words("2") + Words{at("a.png")});
  EXPECT_EQ(wait_for(first), 0);
  EXPECT_EQ(wait_for(second), 0);
  const std::string left = content_of(at("a.png"));
  EXPECT_TRUE(left == one || left == two);
  EXPECT_EQ(folder_.count(), 1u);
}

} // namespace
} // namespace unghost
