// What a window shows: where everything lies, and that its pixels are the pictures' own, or made of them.
#include <algorithm>
#include <cmath>

#include "app/measure/magma.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

constexpr glm::ivec2 window_sizes[] = {{1, 1}, {2, 9}, {37, 23}, {320, 180}, {480, 270}, {961, 541}};

int right_of(const ScreenRect& rect) { return rect.x + rect.width; }
int bottom_of(const ScreenRect& rect) { return rect.y + rect.height; }
bool is_in(const ScreenRect& rect, double x, double y) {
  return x >= rect.x && y >= rect.y && x < right_of(rect) && y < bottom_of(rect);
}
bool is_in(const ScreenRect& inner, const ScreenRect& outer) {
  return inner.x >= outer.x && inner.y >= outer.y && right_of(inner) <= right_of(outer) &&
         bottom_of(inner) <= bottom_of(outer);
}
ScreenRect grown(const ScreenRect& rect, uint32_t by) {
  const int more = int(by);
  return {rect.x - more, rect.y - more, rect.width + 2 * more, rect.height + 2 * more};
}
bool overlap(const ScreenRect& a, const ScreenRect& b) {
  return a.x < right_of(b) && b.x < right_of(a) && a.y < bottom_of(b) && b.y < bottom_of(a);
}

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

using Pixel = glm::u8vec4;

Pixel pixel_of(const Image& image, int x, int y) {
  const size_t at = (size_t(y) * image.width + size_t(x)) * 4;
  return {image.rgba[at], image.rgba[at + 1], image.rgba[at + 2], image.rgba[at + 3]};
}
/// Beyond the edge the edge goes on.
Pixel nearest_pixel_of(const Image& image, int x, int y) {
  return pixel_of(image, std::clamp(x, 0, int(image.width) - 1), std::clamp(y, 0, int(image.height) - 1));
}

struct Shot {
  Image screen;
  std::vector<Image> displays;
};

class Screen : public StudioTest {
protected:
  static constexpr glm::ivec2 picture{320, 180};

  static FrameResult draw(const ScreenInput& screen, const std::vector<std::string>& modes,
                          std::vector<Wanted> wanted, glm::ivec2 size = picture) {
    FrameResult result;
    for (int index = 0; index < 3; ++index) {
      FrameInput input = studio->frame("drive", index, {}, index == 2 ? wanted : std::vector<Wanted>{});
      for (const std::string& mode : modes) input.modes.push_back(run_of(mode));
      input.width = uint32_t(size.x), input.height = uint32_t(size.y);
      input.screen = screen;
      result = studio->renderer.render(input);
    }
    return result;
  }
  static Shot shoot(const ScreenInput& screen, const std::vector<std::string>& modes,
                    glm::ivec2 size = picture) {
    std::vector<Wanted> wanted{{Output::screen}};
    for (size_t mode = 0; mode < modes.size(); ++mode) wanted.push_back({Output::display, mode});
    FrameResult result = draw(screen, modes, wanted, size);
    Shot shot{.screen = std::move(result.delivered[0].picture), .displays = {}};
    for (size_t mode = 0; mode < modes.size(); ++mode)
      shot.displays.push_back(std::move(result.delivered[mode + 1].picture));
    EXPECT_EQ(shot.screen.width, screen.width);
    EXPECT_EQ(shot.screen.height, screen.height);
    return shot;
  }
  static std::vector<std::string> passes(const FrameResult& result) {
    std::vector<std::string> names;
    for (const PassReport& pass : result.passes) names.push_back(pass.name);
    return names;
  }
  static ScreenInput window(Arrangement arrangement, glm::ivec2 size = picture) {
    return {.width = uint32_t(size.x), .height = uint32_t(size.y), .arrangement = arrangement};
  }
};

TEST_F(Screen, NothingOfItIsMadeUnlessAskedFor) {
  FrameInput input = studio->frame("drive", 0, {run_of("off"), run_of("blend")}, {});
  input.shown = true;
  const std::vector<std::string> without = passes(studio->renderer.render(input));
  EXPECT_EQ(std::ranges::count(without, "screen"), 0);
  input.screen = window(Arrangement::split);
  const std::vector<std::string> with = passes(studio->renderer.render(input));
  EXPECT_EQ(std::ranges::count(with, "screen"), 1);
  EXPECT_EQ(std::ranges::count(with, "tone map"), 2);
  input.shown = false;
  EXPECT_EQ(std::ranges::count(passes(studio->renderer.render(input)), "screen"), 0) << "nobody wants it";
}

TEST_F(Screen, WhatIsNotSeenIsNotMade) {
  const auto tone_maps = [](const ScreenInput& screen) {
    const auto names = passes(draw(screen, {"off", "blend", "grand-tour"}, {{Output::screen}}));
    return std::ranges::count(names, "tone map");
  };
  EXPECT_EQ(tone_maps(window(Arrangement::single)), 1);
  EXPECT_EQ(tone_maps(window(Arrangement::single, {400, 225})), 1);
  EXPECT_EQ(tone_maps(window(Arrangement::split)), 2);
  EXPECT_EQ(tone_maps(window(Arrangement::difference)), 2);
  EXPECT_EQ(tone_maps(window(Arrangement::grid)), 3);
}

TEST_F(Screen, APictureOfTheWindowsSizeIsPassedOn) {
  const Shot shot = shoot(window(Arrangement::single), {"blend", "off"});
  EXPECT_EQ(shot.screen.rgba, shot.displays[0].rgba);
  const auto names = passes(draw(window(Arrangement::single), {"blend", "off"}, {{Output::screen}}));
  EXPECT_EQ(std::ranges::count(names, "screen"), 0) << "at no cost";
  for (const Arrangement of_two : {Arrangement::split, Arrangement::grid, Arrangement::difference}) {
    const Shot alone = shoot(window(of_two), {"blend"});
    EXPECT_EQ(alone.screen.rgba, alone.displays[0].rgba) << "one mode is shown alone";
  }
}

TEST_F(Screen, EachSideOfTheBarIsItsModeToTheBit) {
  for (const double split : {0.0, 0.3, 1.0}) {
    ScreenInput screen = window(Arrangement::split);
    screen.split = split;
    const Shot shot = shoot(screen, {"off", "blend"});
    ASSERT_NE(shot.displays[0].rgba, shot.displays[1].rgba);
    const int bar = std::clamp(int(std::lround(split * picture.x)) - 1, 0, picture.x - 2);
    for (int y = 0; y < picture.y; ++y)
      for (int x = 0; x < picture.x; ++x) {
        const Pixel is = pixel_of(shot.screen, x, y);
        if (x >= bar && x < bar + 2)
          ASSERT_EQ(is, Pixel(255)) << x << " " << y;
        else
          ASSERT_EQ(is, pixel_of(shot.displays[x < bar ? 0 : 1], x, y)) << x << " " << y;
      }
  }
}

/// How the picture is magnified in a cell where it is shown pixel by pixel, and that it is untouched around.
void expect_magnified(const Shot& shot, const ScreenCell& cell, const Magnifier& magnifier) {
  const Image& display = shot.displays[cell.mode];
  const auto lens = lens_in(cell, magnifier, {display.width, display.height});
  ASSERT_TRUE(lens);
  for (int y = cell.shown.y; y < bottom_of(cell.shown); ++y)
    for (int x = cell.shown.x; x < right_of(cell.shown); ++x) {
      const Pixel is = pixel_of(shot.screen, x, y);
      if (is_in(lens->inset, x, y)) {
        const glm::ivec2 texel = lens->region_px + (glm::ivec2(x, y) - lens->region_at) / lens->block;
        ASSERT_EQ(is, pixel_of(display, texel.x, texel.y)) << x << " " << y;
      } else if (is_in(grown(lens->inset, SCREEN_LIGHT_BORDER), x, y) ||
                 (is_in(grown(lens->region, 1), x, y) && !is_in(lens->region, x, y))) {
        ASSERT_EQ(is, Pixel(255)) << x << " " << y;
      } else if (!is_in(grown(lens->inset, SCREEN_BORDER), x, y) &&
                 (!is_in(grown(lens->region, SCREEN_OUTLINE), x, y) || is_in(lens->region, x, y))) {
        ASSERT_EQ(is, pixel_of(display, x, y)) << x << " " << y;
      }
    }
}

TEST_F(Screen, WhatIsMagnifiedAreThePicturesPixels) {
  for (const Arrangement arrangement : {Arrangement::single, Arrangement::split}) {
    ScreenInput screen = window(arrangement);
    screen.magnifier = {.shown = true, .centre = {0.42, 0.55}};
    const Shot shot = shoot(screen, {"off", "blend"});
    for (const ScreenCell& cell : cells_of(screen, 2)) expect_magnified(shot, cell, screen.magnifier);
  }
}

TEST_F(Screen, PixelsAreMagnifiedWithoutAFilterWhereThePictureIsScaled) {
  for (const auto& [arrangement, size] :
       {std::pair{Arrangement::single, glm::ivec2(480, 270)}, {Arrangement::grid, picture}}) {
    ScreenInput screen = window(arrangement, size);
    screen.magnifier = {.shown = true, .centre = {0.42, 0.45}};
    const Shot shot = shoot(screen, {"off", "blend", "grand-tour"});
    for (const ScreenCell& cell : cells_of(screen, 3)) {
      const ScreenLens lens = lens_in(cell, screen.magnifier, picture).value();
      for (int y = 0; y < lens.inset.height; ++y)
        for (int x = 0; x < lens.inset.width; ++x)
          ASSERT_EQ(pixel_of(shot.screen, lens.inset.x + x, lens.inset.y + y),
                    pixel_of(shot.displays[cell.mode], lens.region_px.x + x / lens.block,
                             lens.region_px.y + y / lens.block));
    }
  }
}

double catmull_rom(double far) {
  if (far < 1) return (1.5 * far - 2.5) * far * far + 1;
  return far < 2 ? ((-0.5 * far + 2.5) * far - 4) * far + 2 : 0;
}

/// What an enlarged picture is at `at`, in its pixels, and what it must not leave.
struct Enlarged {
  glm::dvec3 colour{0};
  glm::ivec3 low{255}, high{0};       // of the two by two around
  glm::ivec3 lowest{255}, highest{0}; // of four by four
};
Enlarged enlarged(const Image& image, glm::dvec2 at) {
  Enlarged result;
  const glm::ivec2 corner(glm::floor(at - 0.5));
  for (int y = -1; y <= 2; ++y)
    for (int x = -1; x <= 2; ++x) {
      const glm::ivec3 texel(nearest_pixel_of(image, corner.x + x, corner.y + y));
      const glm::dvec2 far = glm::abs(at - 0.5 - glm::dvec2(corner + glm::ivec2(x, y)));
      result.colour += catmull_rom(far.x) * catmull_rom(far.y) * glm::dvec3(texel);
      result.lowest = glm::min(result.lowest, texel), result.highest = glm::max(result.highest, texel);
      if (far.x >= 1 || far.y >= 1) continue;
      result.low = glm::min(result.low, texel), result.high = glm::max(result.high, texel);
    }
  result.colour = glm::clamp(result.colour, glm::dvec3(result.low), glm::dvec3(result.high));
  return result;
}

TEST_F(Screen, EnlargedSharplyWithoutRinging) {
  for (const glm::ivec2 size : {glm::ivec2(480, 270), glm::ivec2(351, 197), glm::ivec2(640, 360)}) {
    const Shot shot = shoot(window(Arrangement::single, size), {"off"});
    size_t constant = 0, sharp = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const glm::dvec2 at = (glm::dvec2(x, y) + 0.5) * glm::dvec2(picture) / glm::dvec2(size);
        const Enlarged wanted = enlarged(shot.displays[0], at);
        const glm::ivec3 is(pixel_of(shot.screen, x, y));
        for (int channel = 0; channel < 3; ++channel) {
          ASSERT_NEAR(is[channel], wanted.colour[channel], 0.51) << x << " " << y;
          ASSERT_GE(is[channel], wanted.lowest[channel]) << x << " " << y;
          ASSERT_LE(is[channel], wanted.highest[channel]) << x << " " << y;
        }
        constant += wanted.lowest == wanted.highest;
        sharp += glm::distance(glm::dvec3(wanted.lowest), glm::dvec3(wanted.highest)) > 100;
      }
    EXPECT_GT(constant, 100u) << "what is constant stayed so";
    EXPECT_GT(sharp, 100u);
  }
}

/// The mean of light over a pixel's area, light being the square of a colour.
glm::dvec3 mean_over(const Image& image, glm::dvec2 from, glm::dvec2 to) {
  glm::dvec3 sum(0);
  for (int y = int(from.y); y < to.y; ++y)
    for (int x = int(from.x); x < to.x; ++x) {
      const glm::dvec2 low = glm::max(from, glm::dvec2(x, y)), high = glm::min(to, glm::dvec2(x + 1, y + 1));
      const glm::dvec3 colour(nearest_pixel_of(image, x, y));
      sum += std::max(high.x - low.x, 0.0) * std::max(high.y - low.y, 0.0) * colour * colour;
    }
  return glm::sqrt(sum / ((to.x - from.x) * (to.y - from.y)));
}

TEST_F(Screen, AGridsPicturesAreMeansOverTheirPixels) {
  const std::vector<std::string> modes{"off", "blend", "grand-tour", "gdk-clamp"};
  for (const size_t count : {2, 3, 4}) {
    const ScreenInput screen = window(Arrangement::grid);
    const Shot shot = shoot(screen, {modes.begin(), modes.begin() + long(count)});
    const std::vector<ScreenCell> cells = cells_of(screen, count);
    for (const ScreenCell& cell : cells) {
      const glm::dvec2 step = glm::dvec2(picture) / glm::dvec2(cell.picture.width, cell.picture.height);
      for (int y = 0; y < cell.picture.height; ++y)
        for (int x = 0; x < cell.picture.width; ++x) {
          const glm::dvec2 from = glm::dvec2(x, y) * step;
          const glm::dvec3 mean = mean_over(shot.displays[cell.mode], from, from + step);
          const glm::ivec3 is(pixel_of(shot.screen, cell.picture.x + x, cell.picture.y + y));
          for (int channel = 0; channel < 3; ++channel) ASSERT_NEAR(is[channel], mean[channel], 0.52);
        }
    }
    for (int y = 0; y < picture.y; ++y)
      for (int x = 0; x < picture.x; ++x) {
        const auto shows = [&](const ScreenCell& cell) { return is_in(cell.shown, x, y); };
        if (std::ranges::any_of(cells, shows)) continue;
        ASSERT_LT(pixel_of(shot.screen, x, y).y, 32) << "dark at " << x << " " << y;
      }
  }
}

TEST_F(Screen, ADifferenceIsTheLargestOfAChannelTimesEight) {
  const Shot shot = shoot(window(Arrangement::difference), {"off", "blend"});
  FloatImage largest{
      .width = uint32_t(picture.x), .height = uint32_t(picture.y), .channels = 1, .values = {}};
  for (int y = 0; y < picture.y; ++y)
    for (int x = 0; x < picture.x; ++x) {
      const glm::ivec3 apart = glm::abs(glm::ivec3(pixel_of(shot.displays[0], x, y)) -
                                        glm::ivec3(pixel_of(shot.displays[1], x, y)));
      largest.values.push_back(std::min(float(8 * std::max({apart.x, apart.y, apart.z})) / 255, 1.0f));
    }
  EXPECT_EQ(*std::ranges::max_element(largest.values), 1);
  const Image expected = magma(largest);
  for (size_t i = 0; i < expected.rgba.size(); ++i)
    ASSERT_NEAR(shot.screen.rgba[i], expected.rgba[i], 1) << i;
}

TEST_F(Screen, AModeDoesNotDifferFromItselfAtAnySize) {
  for (const glm::ivec2 size : {picture, {480, 270}, {200, 113}})
    for (const bool magnified : {false, true}) {
      ScreenInput screen = window(Arrangement::difference, size);
      screen.magnifier.shown = magnified;
      const Shot shot = shoot(screen, {"blend", "blend"});
      size_t marked = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) marked += glm::ivec3(pixel_of(shot.screen, x, y)) != glm::ivec3(0);
      if (!magnified)
        EXPECT_EQ(marked, 0u);
      else
        EXPECT_LT(marked, 3u * uint32_t(size.x + size.y)) << "the frames alone";
    }
}

TEST_F(Screen, EveryPixelOfEverySizeIsDrawn) {
  for (const Answer& arrangement : answers<Arrangement>())
    for (const glm::ivec2 size : window_sizes)
      for (const glm::ivec2 of : {glm::ivec2(1, 1), glm::ivec2(63, 35)}) {
        ScreenInput screen = window(Arrangement(arrangement.value), size);
        screen.magnifier.shown = true;
        const Shot shot = shoot(screen, {"off", "blend", "grand-tour"}, of);
        for (size_t i = 3; i < shot.screen.rgba.size(); i += 4) ASSERT_EQ(shot.screen.rgba[i], 255);
      }
}

TEST_F(Screen, AWindowThatNoDeviceDrawsIsRefused) {
  EXPECT_THROW(draw(window(Arrangement::single, {1 << 20, 8}), {"off"}, {{Output::screen}}), GpuError);
}

} // namespace
} // namespace unghost
