#include "app/reference_files.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "tests/app/child.h"
#include "tests/app/fake_film.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

namespace fs = std::filesystem;

class ReferenceFiles : public testing::Test {
protected:
  ReferenceFiles() {
    if (const char* before = getenv("XDG_CACHE_HOME")) before_ = before;
    setenv("XDG_CACHE_HOME", folder_.path.c_str(), 1);
    shot_.size = {fake_width, fake_height};
  }
  ~ReferenceFiles() override {
    before_.empty() ? unsetenv("XDG_CACHE_HOME") : setenv("XDG_CACHE_HOME", before_.c_str(), 1);
  }

  /// As another run would: which samples it drew for a reference of frame 5.
  size_t samples_drawn() {
    FakeFilm film([this](const FrameInput&, const ModeRun&, uint32_t, uint32_t) { return grey_; });
    const Image reference =
        supersampled_reference(film.film, 5, 8, reference_files(film.film, shot_, device_));
    EXPECT_EQ(reference.rgba[0], displayed_8_bit({1, 1, 3, {grey_, grey_, grey_}}, 0).rgba[0]);
    return size_t(
        std::ranges::count_if(film.drawn, [](const FrameInput& f) { return f.jitter_px.has_value(); }));
  }
  fs::path kept() const { return folder_.path / "unghost" / "references"; }

  ScratchFolder folder_;
  std::string before_, device_ = "a device, its driver";
  Shot shot_;
  float grey_ = 0.25f;
};

TEST_F(ReferenceFiles, WhatWasDrawnIsNotDrawnAgain) {
  EXPECT_EQ(samples_drawn(), 8u);
  EXPECT_EQ(samples_drawn(), 0u);
}

TEST_F(ReferenceFiles, WhateverItDependsOnMakesItAnother) {
  samples_drawn();
  grey_ = 0.5f; // another scene in the same file: the aliased frame differs
  EXPECT_EQ(samples_drawn(), 8u);
  device_ = "another";
  EXPECT_EQ(samples_drawn(), 8u);
  shot_.seed = 2;
  EXPECT_EQ(samples_drawn(), 8u);
  shot_.rig = "pass";
  EXPECT_EQ(samples_drawn(), 8u);
  shot_.settings.light.exposure_ev = 1;
  EXPECT_EQ(samples_drawn(), 8u);
  EXPECT_EQ(samples_drawn(), 0u);
}

TEST_F(ReferenceFiles, ABrokenFileIsDrawnAgainAndMended) {
  samples_drawn();
  const fs::path file = fs::directory_iterator(kept())->path();
  const std::string whole = content_of(file);
  std::string noise, flipped = whole;
  std::mt19937 random(1);
  while (noise.size() < whole.size()) noise += char(random());
  flipped[flipped.size() - 20] = char(flipped[flipped.size() - 20] ^ 1); // in the pixels
  for (const std::string& broken : {std::string(), whole.substr(0, 60), noise, flipped}) {
    std::ofstream(file, std::ios::binary) << broken;
    EXPECT_EQ(samples_drawn(), 8u) << broken.size();
    EXPECT_EQ(samples_drawn(), 0u);
    EXPECT_EQ(content_of(file), whole);
  }
}

TEST_F(ReferenceFiles, WithoutAPlaceTheFiguresAreThereAllTheSame) {
  folder_.file("unghost", "no folder");
  EXPECT_EQ(samples_drawn(), 8u);
  EXPECT_EQ(samples_drawn(), 8u);
}

} // namespace
} // namespace unghost
