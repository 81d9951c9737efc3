// Pictures of another size than what the window shows them in.
#include <algorithm>
#include <cmath>

#include "tests/renderer/screen_rects.h"
#include "tests/renderer/screen_shot.h"

namespace unghost {
namespace {

using ScreenScaling = ScreenTest;

/// Beyond the edge the edge goes on.
Pixel nearest_pixel_of(const Image& image, int x, int y) {
  return pixel_of(image, std::clamp(x, 0, int(image.width) - 1), std::clamp(y, 0, int(image.height) - 1));
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

TEST_F(ScreenScaling, EnlargedSharplyWithoutRinging) {
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

TEST_F(ScreenScaling, AGridsPicturesAreMeansOverTheirPixels) {
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

} // namespace
} // namespace unghost
