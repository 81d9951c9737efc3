#include "app/files.h"

#include <csignal>
#include <cstddef>

#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>

#include "app/failure.h"
#include "tests/app/child.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

const std::vector<uint8_t> hello = {'h', 'e', 'l', 'l', 'o'};

std::pair<Exit, std::string> failure_of(auto&& act) {
  try {
    act();
  } catch (const Failure& failure) {
    return {failure.exit, failure.what()};
  }
  return {Exit::done, ""};
}

TEST(NewFile, AppearsWithItsContentAndLeavesNothingElse) {
  const ScratchFolder folder;
  write_file(folder.path / "a.png", hello);
  EXPECT_EQ(read_file(folder.path / "a.png", 100), hello);
  EXPECT_EQ(folder.count(), 1u);
}

TEST(NewFile, KeepsWhatWasThereUntilItIsWhole) {
  const ScratchFolder folder;
  const fs::path file = folder.file("a.png", "old");
  {
    NewFile unfinished(file);
    unfinished.write(hello);
    EXPECT_EQ(read_file(file, 100).size(), 3u);
  }
  EXPECT_EQ(read_file(file, 100).size(), 3u);
  EXPECT_EQ(folder.count(), 1u) << "the passing file is gone";
  write_file(file, hello);
  EXPECT_EQ(read_file(file, 100), hello);
}

TEST(NewFile, SaysWhyItCannotBeWritten) {
  const ScratchFolder folder;
  const auto [exit, missing] = failure_of([&] { NewFile(folder.path / "no" / "a.png"); });
  EXPECT_EQ(exit, Exit::failed);
  EXPECT_NE(missing.find("a.png: there is no folder"), std::string::npos) << missing;
  EXPECT_NE(failure_of([&] { NewFile{folder.path}; }).second.find("it is a folder"), std::string::npos);
  const auto [full_exit, full] = failure_of([] { write_file("/dev/full", hello); });
  EXPECT_EQ(full_exit, Exit::failed);
  EXPECT_NE(full.find("No space left"), std::string::npos) << full;
}

TEST(NewFile, ReplacesWhatAKilledProcessLeft) {
  const ScratchFolder folder;
  folder.file(".a.png.0.part", "left"), folder.file(".a.png.1.part", "left");
  write_file(folder.path / "a.png", hello);
  write_file(folder.path / "a.png", hello);
  EXPECT_EQ(read_file(folder.path / "a.png", 100), hello);
  EXPECT_EQ(content_of(folder.path / ".a.png.1.part"), "left") << "the first free name is taken";
  EXPECT_EQ(folder.count(), 2u);
}

TEST(NewFile, SparesWhatAnotherStillWrites) {
  const ScratchFolder folder;
  const fs::path others = folder.file(".a.png.0.part", "being written");
  const int descriptor = open(others.c_str(), O_WRONLY | O_CLOEXEC);
  ASSERT_EQ(flock(descriptor, LOCK_EX | LOCK_NB), 0);
  write_file(folder.path / "a.png", hello);
  EXPECT_EQ(content_of(others), "being written");
  EXPECT_EQ(read_file(folder.path / "a.png", 100), hello);
  EXPECT_EQ(folder.count(), 2u);
  close(descriptor);
  write_file(folder.path / "a.png", hello);
  EXPECT_EQ(folder.count(), 1u) << "its writer has ended";
}

/// From here on, as on a file system that knows no files without a name.
void forbid_nameless_files() {
  const sock_filter rules[] = {
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
      BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_openat, 0, 3),
      BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[2])),
      BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, O_TMPFILE & ~O_DIRECTORY, 0, 1),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EOPNOTSUPP),
      BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
  };
  const sock_fprog program{.len = std::size(rules), .filter = const_cast<sock_filter*>(rules)};
  if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
      prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0)
    _exit(77);
}

TEST(NewFile, IsWholeAndAloneWhereFilesNeedANameToo) {
  const ScratchFolder folder;
  const fs::path file = folder.path / "a.png";
  const pid_t killed = fork(); // in the middle of it
  if (killed == 0) {
    forbid_nameless_files();
    NewFile unfinished(file);
    unfinished.write(hello);
    raise(SIGKILL);
  }
  const int ended = wait_for(killed);
  if (ended == 77) GTEST_SKIP() << "there is no seccomp here";
  EXPECT_EQ(ended, 128 + SIGKILL);
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(folder.count(), 1u) << "what it left";
  const pid_t next = fork();
  if (next == 0) {
    forbid_nameless_files();
    const NewFile abandoned(file), other(folder.path / "b.png");
    write_file(file, hello); // beside one that is not finished
    _exit(folder.count() == 3 ? 0 : 1);
  }
  EXPECT_EQ(wait_for(next), 0);
  EXPECT_EQ(read_file(file, 100), hello);
  write_file(file, hello);
  EXPECT_EQ(folder.count(), 2u) << "and what was left of b.png";
}

TEST(NewFile, WritesToADeviceInsteadOfReplacingIt) {
  write_file("/dev/null", hello);
  struct stat facts {};
  ASSERT_EQ(stat("/dev/null", &facts), 0);
  EXPECT_TRUE(S_ISCHR(facts.st_mode));
}

TEST(NewFile, FollowsALinkInsteadOfReplacingIt) {
  const ScratchFolder folder;
  folder.file("real.png", "old");
  fs::create_symlink(folder.path / "real.png", folder.path / "link.png");
  write_file(folder.path / "link.png", hello);
  EXPECT_TRUE(fs::is_symlink(folder.path / "link.png"));
  EXPECT_EQ(read_file(folder.path / "real.png", 100), hello);
}

TEST(ReadFile, RefusesWhatIsNoFileOrTooLarge) {
  const ScratchFolder folder;
  const fs::path file = folder.file("a", "12345"), pipe = folder.path / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(failure_of([&] { read_file(file, 4); }).first, Exit::input_refused);
  EXPECT_EQ(failure_of([&] { read_file(pipe, 4); }).first, Exit::input_refused) << "and does not hang";
  EXPECT_EQ(failure_of([&] { read_file(folder.path, 4); }).first, Exit::input_refused);
  EXPECT_EQ(failure_of([&] { read_file(folder.path / "no", 4); }).first, Exit::input_refused);
}

TEST(MakeFolder, SaysWhyItCannot) {
  const ScratchFolder folder;
  make_folder(folder.path / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder.path / "a" / "b"));
  folder.file("file", "");
  EXPECT_EQ(failure_of([&] { make_folder(folder.path / "file" / "b"); }).first, Exit::failed);
}

TEST(Files, NothingIsThereBeforeAllOfItIs) {
  const ScratchFolder folder;
  const std::vector<uint8_t> bytes(1000, 7);
  NewFile file(folder.path / "a.png");
  file.write(bytes);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path)) << "what ends the process now leaves nothing behind";
  file.commit();
  EXPECT_EQ(read_file(folder.path / "a.png", 1 << 20), bytes);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path), {}), 1);
}

} // namespace
} // namespace unghost
