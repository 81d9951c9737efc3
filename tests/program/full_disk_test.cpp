// Disks that take no more: by a limit on how large a file may grow, and, where a test may mount, by a small
// disk.
#include <sched.h>
#include <sys/mount.h>

#include "tests/program/program.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

constexpr const char* old = "what was there before";

class FullDisk : public ProgramTest {
protected:
  static Words files_at_most(const std::string& bytes) { return {"prlimit", "--fsize=" + bytes, "--"}; }

  void expect_old_and_nothing_else(const std::string& name) const {
    EXPECT_EQ(content_of(at(name)), old) << name;
    EXPECT_EQ(folder_.count(), 1u) << name;
  }
};

TEST_F(FullDisk, AFileThatMayNotGrowIsOneASentenceAndTheOldFile) {
  const Words exr = {"capture", "--size", "64x36", "--frames", "2", "-q", "-o"};
  const Words figures = {"measure", "--size",   "64x36", "--what",    "ghosting", "--modes",
                         "blend",   "--frames", "20",    "--no-json", "-q",       "-o"};
  for (const auto& [words, name] : {std::pair{small_capture, "a.png"}, {exr, "a.exr"}, {figures, "a.json"}}) {
    folder_.file(name, old);
    const Ended full = run(words + Words{at(name)}, files_at_most("1000"));
    EXPECT_EQ(full.exit, 1) << full.talk;
    expect_sentence(full, {"cannot write", at(name), "File too large"});
    expect_old_and_nothing_else(name);
    fs::remove(at(name));
  }
}

TEST_F(FullDisk, ASequenceKeepsTheFramesThatWereWritten) {
  const Words words = {"capture", "--size", "64x36", "--frames", "3", "-q", "--sequence", at("frames"), "-o"};
  const Ended full = run(words + Words{at("last.png")}, files_at_most("1000"));
  EXPECT_EQ(full.exit, 1) << full.talk;
  expect_sentence(full, {"cannot write", at("frames"), "File too large"});
  EXPECT_TRUE(fs::is_empty(at("frames")));
  EXPECT_FALSE(fs::exists(at("last.png")));
}

class SmallDisk : public FullDisk {
protected:
  void SetUp() override {
    // in a view of the file systems that ends with this process
    const bool mounted = unshare(CLONE_NEWNS) == 0 &&
                         mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                         mount("tmpfs", folder_.path.c_str(), "tmpfs", 0, "size=64k") == 0;
    if (!mounted) GTEST_SKIP() << "mounting needs root";
  }
  void TearDown() override { umount(folder_.path.c_str()); }

  void fill() const { std::ofstream(folder_.path / "filler") << std::string(1 << 20, 'x') << std::flush; }
};

TEST_F(SmallDisk, APictureThatDoesNotFitIsOneASentenceAndTheOldFile) {
  folder_.file("a.png", old);
  fill();
  const Ended full = run(small_capture + Words{at("a.png")});
  EXPECT_EQ(full.exit, 1) << full.talk;
  expect_sentence(full, {"cannot write", at("a.png"), "No space left"});
  EXPECT_EQ(content_of(at("a.png")), old);
  EXPECT_EQ(folder_.count(), 2u);
  fs::remove(at("filler"));
  EXPECT_EQ(run(small_capture + Words{at("a.png")}).exit, 0) << "and with room again it is written";
  EXPECT_NE(content_of(at("a.png")), old);
}

TEST_F(SmallDisk, AReportThatDoesNotFitLeavesTheOldOneWhole) {
  const ScratchFolder elsewhere;
  const std::string figures = (elsewhere.path / "a.json").string();
  ASSERT_EQ(run({"measure", "--size", "64x36", "--what", "ghosting", "--modes", "blend,uncharted", "--frames",
                 "20", "-q", "-o", figures})
                .exit,
            0);
  const Words report = {"report", "--from", figures, "-q", "-o", folder_.path.string()};
  for (const char* name : {"results.json", "results.csv", "index.html"}) folder_.file(name, old);
  const Ended full = run(report); // its page alone is more than the disk
  EXPECT_EQ(full.exit, 1) << full.talk;
  expect_sentence(full, {"cannot write", at("index.html"), "No space left"});
  for (const char* name : {"results.json", "results.csv", "index.html"})
    EXPECT_EQ(content_of(at(name)), old) << name;
  EXPECT_EQ(folder_.count(), 3u);
}

} // namespace
} // namespace unghost
