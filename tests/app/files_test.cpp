#include "app/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "app/failure.h"
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
