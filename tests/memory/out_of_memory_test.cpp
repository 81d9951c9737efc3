// Less memory than is wanted: of what our own code asks for, all that goes over a limit of the test's is
// refused. The driver's code is spared, which does not bear it; see tests/fault_layer for the device's
// memory.
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <new>

#include <gtest/gtest.h>

#include "app/files.h"
#include "app/png_file.h"
#include "tests/app/outcome.h"
#include "tests/app/scratch_folder.h"

extern "C" const char __executable_start, etext;

namespace {

constexpr long no_limit = 1L << 60;
// bytes: less than this is found, as it is in practice; nlohmann-json's destructor ends the process where it
// is not
constexpr long large = 64 << 10;
std::atomic<long> limit = no_limit, held = 0, most = 0;

/// Before each piece of memory; two of them keep its alignment.
struct Header {
  long counted;
  long unused;
};

bool is_ours(const void* caller) { return caller >= &__executable_start && caller < &etext; }

void* taken(size_t size, const void* caller) {
  const long counted = is_ours(caller) ? long(size) : 0;
  if (counted >= large && held + counted > limit) throw std::bad_alloc();
  auto* header = static_cast<Header*>(std::malloc(size + sizeof(Header)));
  if (header == nullptr) throw std::bad_alloc();
  header->counted = counted;
  const long now = held += counted;
  for (long before = most; before < now && !most.compare_exchange_weak(before, now);) {
  }
  return header + 1;
}

void given_back(void* memory) {
  if (memory == nullptr) return;
  Header* header = static_cast<Header*>(memory) - 1;
  held -= header->counted;
  std::free(header);
}

} // namespace

void* operator new(size_t size) { return taken(size, __builtin_return_address(0)); }
void* operator new[](size_t size) { return taken(size, __builtin_return_address(0)); }
void* operator new(size_t size, const std::nothrow_t&) noexcept {
  try {
    return taken(size, __builtin_return_address(0));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void* operator new[](size_t size, const std::nothrow_t& nothrow) noexcept {
  return operator new(size, nothrow);
}
void operator delete(void* memory) noexcept { given_back(memory); }
void operator delete[](void* memory) noexcept { given_back(memory); }
void operator delete(void* memory, size_t) noexcept { given_back(memory); }
void operator delete[](void* memory, size_t) noexcept { given_back(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { given_back(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { given_back(memory); }

namespace unghost {
namespace {

namespace fs = std::filesystem;

class OutOfMemory : public testing::Test {
protected:
  std::string at(const std::string& name) const { return (folder_.path / name).string(); }

  /// Runs the words with `shares` limits, from next to nothing to next to all that they want. Each run has to
  /// end with 5 and a sentence, and without the file `output`.
  void starve(const Words& words, int shares, const std::string& output) const {
    const long before = held;
    most = before;
    const Outcome enough = outcome(words);
    ASSERT_EQ(enough.exit, 0) << enough.err;
    const long wanted = most - before;
    const size_t files = folder_.count();
    fs::remove(output);
    int refused = 0;
    for (int share = 0; share < shares; ++share) {
      limit = held + 20'000 + wanted / shares * share; // so much is wanted for words and sentences
      const Outcome starved = outcome(words);
      limit = no_limit;
      if (starved.exit == 0) { // what it could do without
        fs::remove(output);
        continue;
      }
      ++refused;
      EXPECT_EQ(starved.exit, 5) << share << ": " << starved.err;
      EXPECT_NE(starved.err.find("memory"), std::string::npos) << starved.err;
      EXPECT_FALSE(fs::exists(output)) << share;
      EXPECT_LT(folder_.count(), files) << share << ": nothing half";
    }
    EXPECT_GE(refused, shares / 2) << "of " << wanted << " bytes";
  }

  const ScratchFolder folder_;
};

Image noise(uint32_t width, uint32_t height) {
  Image picture{.name = {}, .width = width, .height = height, .rgba = {}};
  uint32_t state = 1;
  for (size_t i = 0; i < size_t(width) * height * 4; ++i)
    picture.rgba.push_back(uint8_t((state = state * 1664525 + 1013904223) >> 24));
  return picture;
}

TEST_F(OutOfMemory, OfAComparisonWithThreadsIsFiveAndASentence) {
  write_file(at("a.png"), encode_png(noise(160, 120), "{}"));
  write_file(at("b.png"), encode_png(noise(160, 120), "{}"));
  starve({"flip", at("a.png"), at("b.png"), "--threads", "4", "-o", at("map.png")}, 40, at("map.png"));
}

TEST_F(OutOfMemory, OfACaptureIsFiveAndASentence) {
  starve({"capture", "--size", "64x36", "--frames", "2", "-q", "-o", at("a.png")}, 5, at("a.png"));
  starve({"capture", "--size", "64x36", "--frames", "2", "-q", "-o", at("a.exr")}, 4, at("a.exr"));
}

} // namespace
} // namespace unghost
