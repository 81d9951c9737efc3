// FLIP of pictures that are easily made again.
#include "app/measure/flip.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/flat_picture.h"

namespace unghost {
namespace {

FloatImage flat(uint32_t width, uint32_t height, glm::u8vec3 colour) {
  return linear_from_srgb(picture_of(width, height, colour));
}

FloatImage noise(uint32_t width, uint32_t height, uint32_t seed) {
  std::mt19937 random(seed);
  FloatImage image{width, height, 3, std::vector<float>(size_t(width) * height * 3)};
  for (float& value : image.values) value = float(random() % 1024) / 1023;
  return image;
}

// Version 1.6's means for these pictures.
TEST(Flip, FlatPicturesAreAsFarApartAsTheAuthorsSay) {
  const auto mean = [](uint32_t width, uint32_t height, glm::u8vec3 a, glm::u8vec3 b) {
    return summary_of(flip(flat(width, height, a), flat(width, height, b)).values).mean;
  };
  EXPECT_NEAR(mean(64, 64, {128, 128, 128}, {138, 138, 138}), 0.14901033, 1e-4);
  EXPECT_NEAR(mean(40, 40, {0, 0, 0}, {255, 255, 255}), 0.967388332, 1e-4);
  EXPECT_NEAR(mean(1, 1, {255, 0, 0}, {0, 255, 0}), 0.986665, 1e-4);
}

TEST(Flip, OfAPictureAndItselfIsExactlyNothing) {
  const FloatImage image = noise(37, 21, 1);
  for (const float error : flip(image, image).values) EXPECT_EQ(error, 0);
}

TEST(Flip, IsTheSameBothWaysAndWithAnyNumberOfThreads) {
  const FloatImage a = noise(53, 71, 1), b = noise(53, 71, 2);
  const std::vector<float> errors = flip(a, b, {.threads = 1}).values;
  EXPECT_EQ(flip(a, b, {.threads = 3}).values, errors);
  EXPECT_EQ(flip(b, a, {.threads = 1}).values, errors);
  for (const float error : errors) EXPECT_TRUE(error >= 0 && error <= 1);
}

TEST(Flip, OfPicturesSeenBeforeIsTheSame) {
  const FloatImage a = noise(53, 171, 1), b = noise(53, 171, 2);
  const FlipOptions one{.pixels_per_degree = 40, .threads = 1}, three{.pixels_per_degree = 40, .threads = 3};
  const std::vector<float> errors = flip(a, b, one).values;
  const SeenPicture reference = seen(a, three), test = seen(b, one);
  EXPECT_EQ(flip(reference, test, three).values, errors);
  const double mean = mean_flip(reference, test, one);
  EXPECT_NEAR(mean, summary_of(errors).mean, 1e-12);
  EXPECT_EQ(mean_flip(reference, test, three), mean);
  EXPECT_EQ(mean_flip(reference, reference, three), 0);
}

TEST(Flip, EightBitsAreSeenAsTheLinearPictureThatTheyStandFor) {
  Image picture = picture_of(19, 33, {0, 0, 0});
  std::mt19937 random(3);
  for (uint8_t& byte : picture.rgba) byte = uint8_t(random());
  const SeenPicture bytes = seen(picture, {.pixels_per_degree = 30}),
                    floats = seen(linear_from_srgb(picture), {.pixels_per_degree = 30});
  EXPECT_EQ(bytes.width, 19u);
  EXPECT_EQ(bytes.height, 33u);
  EXPECT_EQ(bytes.l.size(), 19u * 33);
  for (auto plane :
       {&SeenPicture::l, &SeenPicture::a, &SeenPicture::b, &SeenPicture::edge, &SeenPicture::point})
    EXPECT_EQ(bytes.*plane, floats.*plane);
}

// What lies far away is nothing to an error, at any size and resolution.
TEST(Flip, APixelsErrorStaysAroundIt) {
  FloatImage a = flat(90, 50, {100, 100, 100}), b = a;
  b.values[3 * (25 * 90 + 45)] = 1;
  const FlipOptions options{.pixels_per_degree = 30};
  const FloatImage error = flip(a, b, options);
  EXPECT_GT(error.values[25 * 90 + 45], 0.1);
  EXPECT_LT(error.values[25 * 90 + 10], 1e-6);
  EXPECT_LT(error.values[5 * 90 + 45], 1e-6);
}

TEST(Flip, WeightedQuantilesCountWhatIsLarge) {
  const FlipSummary s = summary_of(std::vector<float>{0, 0, 0, 0.25f, 0.25f, 0.5f});
  EXPECT_DOUBLE_EQ(s.mean, 1.0 / 6);
  EXPECT_EQ(s.weighted_first_quartile, 0.25);
  EXPECT_EQ(s.weighted_median, 0.25);
  EXPECT_EQ(s.weighted_third_quartile, 0.5);
  EXPECT_EQ(s.max, 0.5);
}

TEST(Flip, ExposuresAreDefinedWhereTheMedianIsBlack) {
  FloatImage image = flat(8, 8, {0, 0, 0});
  EXPECT_EQ(exposures_of(image, ToneMapper::aces).count, 2u);
  for (size_t i = 0; i < 9; ++i) image.values[i] = 4;
  const Exposures found = exposures_of(image, ToneMapper::aces);
  EXPECT_TRUE(std::isfinite(found.first) && std::isfinite(found.last));
  EXPECT_NEAR(found.first, std::log2(2.11887 / 4), 1e-4);
}

} // namespace
} // namespace unghost
