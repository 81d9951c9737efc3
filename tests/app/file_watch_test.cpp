#include "app/demo/file_watch.h"

#include <gtest/gtest.h>

#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

using namespace std::chrono_literals;

class FileWatchTest : public testing::Test {
protected:
  /// Looks half a second later.
  bool look() { return watch.changed(now += 500ms); }

  ScratchFolder folder;
  std::filesystem::path file = folder.file("a", "one");
  FileWatch watch;
  FileWatch::Time now{1h};
};

TEST_F(FileWatchTest, WhatRestsHasNotChanged) {
  watch.add({file, folder.path / "none"});
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(look());
}

TEST_F(FileWatchTest, AChangeIsSaidOnceAndWhenItRests) {
  watch.add({file});
  folder.file("a", "half of");
  EXPECT_FALSE(look());
  folder.file("a", "half of two");
  EXPECT_FALSE(look());
  EXPECT_TRUE(look());
  EXPECT_FALSE(look());
  EXPECT_FALSE(look());
}

TEST_F(FileWatchTest, AnotherFileInItsPlaceIsAChange) {
  watch.add({file});
  const auto time = std::filesystem::last_write_time(file);
  const std::filesystem::path other = folder.file("b", "two");
  std::filesystem::last_write_time(other, time); // of the same size and age
  std::filesystem::rename(other, file);
  EXPECT_FALSE(look());
  EXPECT_TRUE(look());
}

TEST_F(FileWatchTest, WhatGoesAndComesBackIsAChangeEachTime) {
  watch.add({file});
  std::filesystem::remove(file);
  EXPECT_FALSE(look());
  EXPECT_TRUE(look());
  folder.file("a", "one");
  EXPECT_FALSE(look());
  EXPECT_TRUE(look());
}

TEST_F(FileWatchTest, AddingAFileAgainForgetsNoChange) {
  watch.add({file});
  folder.file("a", "another");
  watch.add({file});
  EXPECT_FALSE(look());
  EXPECT_TRUE(look());
}

TEST_F(FileWatchTest, ItLooksTwiceASecondAtMost) {
  watch.add({file});
  EXPECT_FALSE(look());
  folder.file("a", "another");
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(watch.changed(now += 100ms)); // not one of them looks
  EXPECT_FALSE(watch.changed(now += 100ms));
  EXPECT_TRUE(look());
}

} // namespace
} // namespace unghost
