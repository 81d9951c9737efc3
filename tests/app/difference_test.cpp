#include "app/difference.h"

#include <gtest/gtest.h>

namespace unghost {
namespace {

Image grey(uint32_t width, uint32_t height, uint8_t value = 100) {
  Image image{.name = "", .width = width, .height = height, .rgba = {}};
  image.rgba.assign(size_t(width) * height * 4, value);
  return image;
}

void fill(Image& image, const Window& window, uint8_t value) {
  for (uint32_t y = window.y; y < window.y + window.height; ++y)
    for (uint32_t x = window.x; x < window.x + window.width; ++x)
      for (uint32_t c = 0; c < 3; ++c) image.rgba[(size_t(y) * image.width + x) * 4 + c] = value;
}

TEST(Difference, WindowsLieOnWhatDiffersMost) {
  const Image a = grey(320, 180);
  Image b = a;
  fill(b, {40, 80, 32, 16}, 20);
  fill(b, {200, 20, 32, 16}, 60);
  const auto windows = windows_of_difference(a, b, 32, 16, 2);
  ASSERT_EQ(windows.size(), 2u);
  EXPECT_EQ(windows[0], (Window{40, 80, 32, 16}));
  EXPECT_EQ(windows[1], (Window{200, 20, 32, 16}));
}

TEST(Difference, LostTextureWeighsLessThanAGhost) {
  Image a = grey(320, 180);
  Image b = a;
  for (uint32_t y = 0; y < 60; ++y) // a checkerboard in one, its mean in the other
    for (uint32_t x = 0; x < 100; ++x) fill(a, {x, y, 1, 1}, (x + y) % 2 ? 160 : 40);
  fill(b, {240, 120, 32, 16}, 90);
  EXPECT_EQ(windows_of_difference(a, b, 32, 16, 1).front(), (Window{240, 120, 32, 16}));
}

TEST(Difference, BothWindowsComeBackWhereTheSizeIsNoMultipleOfABlock) {
  const Image a = grey(960, 540);
  Image b = a;
  fill(b, {0, 440, 960, 100}, 30); // down to the last row
  EXPECT_EQ(windows_of_difference(a, b, 160, 90, 2).size(), 2u);
}

TEST(Difference, WindowsLieInsideThePicture) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {3u, 5u}, {33u, 17u}, {160u, 90u}}) {
    const auto windows =
        windows_of_difference(grey(width, height), grey(width, height, 30), width / 6, height / 6, 2);
    for (const Window& window : windows) {
      EXPECT_LE(window.x + window.width, width);
      EXPECT_LE(window.y + window.height, height);
    }
  }
}

} // namespace
} // namespace unghost
