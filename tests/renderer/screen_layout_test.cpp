// Where everything lies that a window shows.
#include <algorithm>

#include <gtest/gtest.h>

#include "renderer/spelling.h"
#include "tests/renderer/screen_rects.h"

namespace unghost {
namespace {

/// Every arrangement of one to five modes in windows of many sizes.
template <class Check> void for_each_layout(Check check) {
  for (const Answer& arrangement : answers<Arrangement>())
    for (const glm::ivec2 size : window_sizes)
      for (const double split : {0.0, 0.1, 0.5, 1.0})
        for (size_t modes = 1; modes <= 5; ++modes) {
          const ScreenInput screen{.width = uint32_t(size.x),
                                   .height = uint32_t(size.y),
                                   .arrangement = Arrangement(arrangement.value),
                                   .split = split};
          SCOPED_TRACE(arrangement.name + " of " + std::to_string(modes) + " at " + std::to_string(size.x) +
                       "x" + std::to_string(size.y) + ", " + std::to_string(split));
          check(screen, modes);
        }
}

TEST(ScreenLayout, CellsCoverTheWindowOnceAndShowAPartOfTheirPicture) {
  for_each_layout([](const ScreenInput& screen, size_t modes) {
    std::vector<int> covered(size_t(screen.width) * screen.height);
    for (const ScreenCell& cell : cells_of(screen, modes)) {
      EXPECT_LT(cell.mode, modes);
      if (screen.width > 9) {
        EXPECT_TRUE(is_in(cell.shown, cell.covered));
        EXPECT_TRUE(is_in(cell.shown, cell.picture));
      }
      for (int y = cell.covered.y; y < bottom_of(cell.covered); ++y)
        for (int x = cell.covered.x; x < right_of(cell.covered); ++x)
          ++covered.at(size_t(y) * screen.width + size_t(x));
    }
    EXPECT_TRUE(std::ranges::all_of(covered, [](int times) { return times == 1; }));
  });
}

TEST(ScreenLayout, AGridShowsWholePicturesOfOneSizeInTheWindowsAspect) {
  for (const size_t modes : {2, 3, 4, 7}) {
    const std::vector<ScreenCell> cells =
        cells_of({.width = 960, .height = 540, .arrangement = Arrangement::grid}, modes);
    ASSERT_EQ(cells.size(), std::min<size_t>(modes, 4));
    for (size_t i = 0; i < cells.size(); ++i) {
      const ScreenRect& picture = cells[i].picture;
      EXPECT_EQ(cells[i].mode, i);
      EXPECT_TRUE(is_in(picture, cells[i].shown)) << "the whole of it";
      EXPECT_EQ(picture.width, 479);
      EXPECT_EQ(picture.height, 269);
      EXPECT_EQ(picture.x < 480, i % 2 == 0);
      if (modes > 2) {
        EXPECT_EQ(picture.y < 270, i < 2);
      } else {
        EXPECT_NEAR(picture.y, 540 - bottom_of(picture), 1) << "in the middle";
      }
    }
  }
}

TEST(ScreenLayout, APointOfTheWindowIsOneOfItsPicture) {
  for_each_layout([](const ScreenInput& screen, size_t modes) {
    const std::vector<ScreenCell> cells = cells_of(screen, modes);
    for (double y = -1.5; y < screen.height + 2; y += std::max(screen.height / 13.0, 0.5))
      for (double x = -1.5; x < screen.width + 2; x += std::max(screen.width / 29.0, 0.5)) {
        const auto shows = [&](const ScreenCell& cell) { return is_in(cell.shown, x, y); };
        const auto cell = std::ranges::find_if(cells, shows);
        const std::optional<PicturePoint> point = picture_point(screen, modes, x, y);
        ASSERT_EQ(point.has_value(), cell != cells.end());
        if (!point) continue;
        EXPECT_EQ(point->mode, cell->mode);
        EXPECT_GE(std::min(point->at.x, point->at.y), 0);
        EXPECT_LT(std::max(point->at.x, point->at.y), 1);
        EXPECT_NEAR(cell->picture.x + point->at.x * cell->picture.width, x, 1e-9);
        EXPECT_NEAR(cell->picture.y + point->at.y * cell->picture.height, y, 1e-9);
      }
  });
}

TEST(ScreenLayout, AMagnifierLeavesItsRegionFreeAndHoldsWhatItIsPointedAt) {
  size_t lenses = 0;
  for_each_layout([&](const ScreenInput& screen, size_t modes) {
    for (const ScreenCell& cell : cells_of(screen, modes))
      for (const glm::dvec2 centre :
           {glm::dvec2(0.5), glm::dvec2(0), glm::dvec2(1), glm::dvec2(0.3, 0.49), glm::dvec2(0.7, 0.51)})
        for (const double scale : {0.5, 0.7, 1.0}) {
          const glm::ivec2 size = glm::max(
              glm::ivec2(glm::round(scale * glm::dvec2(screen.width, screen.height))), glm::ivec2(1));
          const auto lens = lens_in(cell, {.shown = true, .centre = centre}, size);
          if (!lens) continue;
          ++lenses;
          EXPECT_TRUE(is_in(grown(lens->inset, SCREEN_BORDER), cell.shown));
          EXPECT_FALSE(overlap(grown(lens->inset, SCREEN_BORDER), grown(lens->region, SCREEN_OUTLINE)));
          const glm::dvec2 at = centre * glm::dvec2(cell.picture.width, cell.picture.height);
          EXPECT_TRUE(is_in(grown(lens->region, 1), cell.picture.x + at.x, cell.picture.y + at.y));
        }
  });
  EXPECT_GT(lenses, 1000u);
}

TEST(ScreenLayout, AMagnifierIsATwentiethOfTheWidthSevenTimesAsLarge) {
  const ScreenCell whole = cells_of({.width = 960, .height = 540}, 1)[0];
  const ScreenLens lens = lens_in(whole, {.shown = true, .centre = {0.25, 0.75}}, {960, 540}).value();
  EXPECT_EQ(lens.block, 7);
  EXPECT_EQ(lens.inset.width, 7 * 48);
  EXPECT_EQ(lens.inset.height, 7 * 27);
  EXPECT_EQ(lens.region_px, glm::ivec2(240 - 24, 405 - 13));
  const ScreenLens of_fewer = lens_in(whole, {.shown = true}, {480, 270}).value();
  EXPECT_EQ(of_fewer.block, 14) << "of the window's pixels: as large in the window";
  EXPECT_FALSE(lens_in(whole, {}, {960, 540}));
}

TEST(ScreenLayout, BothSidesOfABarMagnifyTheSame) {
  for (const double split : {0.1, 0.5, 0.8}) {
    const auto cells =
        cells_of({.width = 960, .height = 540, .arrangement = Arrangement::split, .split = split}, 2);
    const Magnifier magnifier{.shown = true, .centre = {0.3, 0.3}};
    const ScreenLens left = lens_in(cells[0], magnifier, {960, 540}).value(),
                     right = lens_in(cells[1], magnifier, {960, 540}).value();
    EXPECT_EQ(left.region_px, right.region_px);
    EXPECT_EQ(left.inset.y, right.inset.y);
    EXPECT_NEAR(right.inset.x - right_of(left.inset), 2 + 2 * (4 + int(SCREEN_BORDER)), 0) << "at the bar";
    // where there is no room for all of it, the middle stays
    EXPECT_NEAR(left.region_at.x + 7 * 24, left.inset.x + left.inset.width / 2.0, 1);
  }
}

} // namespace
} // namespace unghost
