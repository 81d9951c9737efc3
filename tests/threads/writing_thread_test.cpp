#include "app/writing/writing_thread.h"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace unghost {
namespace {

TEST(WritingThread, DoesEverythingInOrder) {
  std::vector<int> done;
  WritingThread thread;
  for (int i = 0; i < 50; ++i) thread.add([&done, i] { done.push_back(i); });
  thread.finish();
  ASSERT_EQ(done.size(), 50u);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(done[size_t(i)], i);
}

TEST(WritingThread, AFaultComesOutAndTheRestIsDropped) {
  std::atomic<int> after = 0;
  WritingThread thread;
  thread.add([] { throw std::runtime_error("full"); });
  const auto all = [&] {
    for (int i = 0; i < 10; ++i) thread.add([&] { ++after; });
    thread.finish();
  };
  EXPECT_THROW(all(), std::runtime_error);
  EXPECT_LT(after, 10);
}

TEST(WritingThread, EndsWithWorkLeft) {
  WritingThread thread;
  for (int i = 0; i < 3; ++i) thread.add([] {});
}

} // namespace
} // namespace unghost
