// What a window shows are the pictures' own pixels, or made of them.
#include <algorithm>
#include <cmath>

#include "app/measure/magma.h"
#include "tests/renderer/screen_rects.h"
#include "tests/renderer/screen_shot.h"

namespace unghost {
namespace {

using Screen = ScreenTest;

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
