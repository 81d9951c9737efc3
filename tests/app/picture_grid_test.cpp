#include "app/picture_grid.h"

#include <gtest/gtest.h>

#include "app/font.h"

namespace unghost {
namespace {

LabelledPicture picture(const std::string& label, uint8_t value, uint32_t width = 96, uint32_t height = 54) {
  Image image{.name = "", .width = width, .height = height, .rgba = {}};
  image.rgba.assign(size_t(width) * height * 4, value);
  return {label, image};
}

uint8_t red(const Image& image, uint32_t x, uint32_t y) {
  return image.rgba[(size_t(y) * image.width + x) * 4];
}

TEST(PictureGrid, FourLieInASquareAndTwoBesideOneAnother) {
  const std::vector<LabelledPicture> four = {picture("a", 50), picture("b", 100), picture("c", 150),
                                             picture("d", 200)};
  const Image grid = picture_grid(four, {});
  EXPECT_EQ(grid.width, 3 * 4 + 2 * 96u);
  EXPECT_EQ(grid.height, 3 * 4 + 2 * 54u);
  EXPECT_EQ(red(grid, 4 + 90, 4 + 50), 50);
  EXPECT_EQ(red(grid, 8 + 96 + 90, 8 + 54 + 50), 200);
  const Image two = picture_grid(std::span(four).first(2), {});
  EXPECT_EQ(two.height, 2 * 4 + 54u);
}

TEST(PictureGrid, ALastRowThatIsNotFullStandsInTheMiddle) {
  std::vector<LabelledPicture> five;
  for (int i = 0; i < 5; ++i) five.push_back(picture("", uint8_t(50 + 40 * i)));
  const Image grid = picture_grid(five, {});
  ASSERT_EQ(grid.width, 4 + 3 * (96 + 4u));
  const uint32_t y = 8 + 54 + 50;
  EXPECT_EQ(red(grid, 4 + 50 - 2, y), 20) << "half a cell is left free";
  EXPECT_EQ(red(grid, 4 + 50 + 1, y), 170);
  EXPECT_EQ(red(grid, grid.width - 4 - 50 - 2, y), 210);
  EXPECT_EQ(red(grid, grid.width - 4 - 50 + 1, y), 20);
}

TEST(PictureGrid, LabelsAreWhiteOnDark) {
  const Image grid = picture_grid(std::vector{picture("I", 100)}, {});
  EXPECT_EQ(red(grid, 4 + 3 + 2, 4 + 3 + 3), 255) << "the stem of the I";
  EXPECT_EQ(red(grid, 4 + 3, 4 + 3 + 3), 20) << "beside it";
  EXPECT_EQ(red(grid, 4 + 80, 4 + 3), 100) << "beyond the label";
}

TEST(PictureGrid, CropsAreEnlargedBelow) {
  LabelledPicture one = picture("a", 100);
  const Window window{40, 20, 16, 9};
  one.picture.rgba[(size_t(25) * 96 + 50) * 4] = 250;
  const Image grid = picture_grid(std::vector{one}, std::vector{window});
  EXPECT_EQ(red(grid, 4 + (50 - 40) * crop_zoom + 1, 4 + 54 + 4 + (25 - 20) * crop_zoom + 1), 250);
  EXPECT_EQ(grid.height, 4 + 54 + 4 + 54 / crop_share * crop_zoom + 4);
}

TEST(PictureGrid, TinyPicturesAndLongNamesFit) {
  const Image grid =
      picture_grid(std::vector{picture("a-very-long-name", 9, 1, 1), picture("b", 9, 1, 1)}, {});
  EXPECT_EQ(grid.rgba.size(), size_t(grid.width) * grid.height * 4);
}

TEST(Font, EveryLetterIsDrawnAndNoTwoAlike) {
  const auto bits = [](char letter) {
    uint64_t all = 0;
    for (uint32_t y = 0; y < glyph_height; ++y)
      for (uint32_t x = 0; x < glyph_width; ++x) all = all * 2 + font_pixel(letter, x, y);
    return all;
  };
  for (char a = '!'; a < 127; ++a) {
    EXPECT_NE(bits(a), 0u) << a;
    for (char b = char(a + 1); b < 127; ++b) EXPECT_NE(bits(a), bits(b)) << a << b;
  }
  EXPECT_EQ(bits(' '), 0u);
  EXPECT_EQ(bits('\x80'), bits('?'));
}

} // namespace
} // namespace unghost
