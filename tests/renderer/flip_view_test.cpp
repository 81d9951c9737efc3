// FLIP on the device: the map that the measurements have of the same pictures, and when and how it is seen.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <optional>
#include <random>

#include "app/measure/flip.h"
#include "app/measure/magma.h"
#include "renderer/frame.h"
#include "tests/renderer/studio.h"

namespace unghost {
namespace {

/// How far a pixel's error, and the mean of them, may be from the processor's: half a step of what is shown.
/// Where colours barely differ beside an edge, an error is a root of what rounding leaves.
constexpr double pixel_tolerance = 0.5 / 255, mean_tolerance = 1e-4;

Image picture_of_size(glm::ivec2 size) {
  const auto width = uint32_t(size.x), height = uint32_t(size.y);
  return {.name = {},
          .width = width,
          .height = height,
          .rgba = std::vector<uint8_t>(size_t(width) * height * 4, 255)};
}

Image noise(glm::ivec2 size, uint32_t seed) {
  Image picture = picture_of_size(size);
  std::mt19937 random(seed);
  for (uint8_t& byte : picture.rgba) byte = uint8_t(random());
  return picture;
}

/// Grey, but for pixels within `wide` of the border.
Image framed(glm::ivec2 size, int wide, uint8_t border) {
  Image picture = picture_of_size(size);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const bool inside = std::min({x, y, size.x - 1 - x, size.y - 1 - y}) >= wide;
      std::fill_n(&picture.rgba[(size_t(y) * picture.width + size_t(x)) * 4], 3, inside ? 128 : border);
    }
  return picture;
}

class FlipOnDevice : public StudioTest {
protected:
  static void TearDownTestSuite() {
    runner.reset(); // before its device
    StudioTest::TearDownTestSuite();
  }
  static inline std::optional<GraphRunner> runner;
  static inline uint64_t frame = 0;

  static FloatImage flip_on_device(const Image& reference, const Image& test) {
    if (!runner) runner.emplace(studio->device, studio->data.shaders);
    runner->make_room();
    FrameGraph graph(runner->kept(), frame++);
    std::deque<GpuBuffer> staged;
    graph.read_back(flip_error(graph, uploaded(graph, reference, staged), uploaded(graph, test, staged)),
                    VK_IMAGE_ASPECT_COLOR_BIT);
    const std::vector<std::byte> bytes = runner->run(graph).readbacks.at(0);
    FloatImage error{.width = reference.width, .height = reference.height, .channels = 1, .values = {}};
    error.values.resize(bytes.size() / sizeof(float));
    std::memcpy(error.values.data(), bytes.data(), bytes.size());
    return error;
  }

  static void expect_agreement(const Image& reference, const Image& test) {
    const FloatImage is = flip_on_device(reference, test), wanted = flip(seen(reference), seen(test));
    ASSERT_EQ(is.values.size(), wanted.values.size());
    double worst = 0, sum = 0, wanted_sum = 0;
    for (size_t i = 0; i < is.values.size(); ++i) {
      ASSERT_FALSE(std::isnan(is.values[i])) << i;
      worst = std::max(worst, std::abs(double(is.values[i]) - wanted.values[i]));
      sum += is.values[i], wanted_sum += wanted.values[i];
    }
    const auto count = double(is.values.size());
    EXPECT_GT(wanted_sum, 0) << "there is something to find";
    EXPECT_LT(worst, pixel_tolerance);
    EXPECT_NEAR(sum / count, wanted_sum / count, mean_tolerance);
  }

  static std::vector<Wanted> wanted_displays(size_t count) {
    std::vector<Wanted> wanted{{Output::screen}};
    for (size_t mode = 0; mode < count; ++mode) wanted.push_back({Output::display, mode});
    return wanted;
  }
  /// The third frame of a drive: the screen, and each mode's display.
  static FrameResult draw(Arrangement arrangement, const std::vector<std::string>& modes,
                          glm::ivec2 window = {320, 180}) {
    FrameResult result;
    for (int index = 0; index < 3; ++index) {
      FrameInput input = studio->frame("drive", index, {}, {});
      for (const std::string& mode : modes) input.modes.push_back(run_of(mode));
      input.screen = {.width = uint32_t(window.x), .height = uint32_t(window.y), .arrangement = arrangement};
      if (index == 2) input.wanted = wanted_displays(modes.size());
      result = studio->renderer.render(input);
    }
    return result;
  }
  static std::ptrdiff_t passes_that_begin(const FrameResult& result, std::string_view words) {
    return std::ranges::count_if(result.passes,
                                 [&](const PassReport& pass) { return pass.name.starts_with(words); });
  }

private:
  static ImageRef uploaded(FrameGraph& graph, const Image& picture, std::deque<GpuBuffer>& staged) {
    GpuBuffer& buffer =
        staged.emplace_back(studio->device, picture.rgba.size(), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
    std::memcpy(buffer.bytes().data(), picture.rgba.data(), picture.rgba.size());
    const VkExtent2D extent{picture.width, picture.height};
    const ImageRef image =
        graph.image({.name = "uploaded", .format = VK_FORMAT_R8G8B8A8_UNORM, .extent = extent});
    graph.pass({.name = "upload",
                .kind = PassKind::transfer,
                .transfers = {{image, Use::transfer_destination}},
                .record = [image, extent, &buffer](PassCommands& commands) {
                  const VkBufferImageCopy whole{.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1},
                                                .imageExtent = {extent.width, extent.height, 1}};
                  vkCmdCopyBufferToImage(commands.commands(), buffer.buffer, commands.image(image),
                                         VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &whole);
                }});
    return image;
  }
};

TEST_F(FlipOnDevice, AgreesOnFramesOfADrive) {
  for (const char* mode : {"blend", "grand-tour"}) {
    const FrameResult result = draw(Arrangement::split, {"off", mode});
    expect_agreement(result.delivered[1].picture, result.delivered[2].picture);
  }
}

TEST_F(FlipOnDevice, AgreesOnNoiseOfEverySize) {
  for (const glm::ivec2 size : {glm::ivec2(1, 1),
                                {1, 9},
                                {9, 1},
                                {2, 3},
                                {31, 33},
                                {33, 31},
                                {64, 64},
                                {65, 97},
                                {257, 12},
                                {321, 181}}) {
    SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y));
    expect_agreement(noise(size, 1), noise(size, 2));
  }
}

TEST_F(FlipOnDevice, AgreesWhereOnlyBordersDiffer) {
  for (const int wide : {1, 4, 11})
    for (const glm::ivec2 size : {glm::ivec2(23, 37), {131, 70}})
      expect_agreement(framed(size, wide, 128), framed(size, wide, 255));
}

TEST_F(FlipOnDevice, FindsAllErrorsFromNoneToTheLargest) {
  const glm::ivec2 size(70, 40);
  Image green = framed(size, 0, 0), blue = green;
  for (size_t i = 0; i < green.rgba.size(); i += 4) {
    green.rgba[i] = blue.rgba[i] = 0, green.rgba[i + 1] = blue.rgba[i + 2] = 255;
    green.rgba[i + 2] = blue.rgba[i + 1] = 0;
  }
  EXPECT_NEAR(flip_on_device(green, blue).values.front(), 1, pixel_tolerance);
  for (const Image& same : {green, noise(size, 3)})
    for (const float error : flip_on_device(same, same).values) ASSERT_EQ(error, 0);
}

TEST_F(FlipOnDevice, IsMadeWhereItIsSeenAlone) {
  const std::vector<std::string> modes{"off", "blend", "grand-tour"};
  for (const Answer& answer : answers<Arrangement>()) {
    const auto arrangement = Arrangement(answer.value);
    SCOPED_TRACE(answer.name);
    EXPECT_EQ(passes_that_begin(draw(arrangement, modes), "FLIP"), arrangement == Arrangement::flip ? 3 : 0);
    EXPECT_EQ(passes_that_begin(draw(arrangement, {"off"}), "FLIP"), 0) << "with nothing to compare";
  }
  FrameInput input = studio->frame("drive", 0, {run_of("off"), run_of("blend"), run_of("grand-tour")}, {});
  input.screen = {.arrangement = Arrangement::flip};
  EXPECT_EQ(passes_that_begin(studio->renderer.render(input), "FLIP"), 0) << "nobody wants it";
  input.shown = true;
  const FrameResult shown = studio->renderer.render(input);
  EXPECT_EQ(passes_that_begin(shown, "FLIP"), 3);
  EXPECT_EQ(passes_that_begin(shown, "tone map"), 2) << "of the two that are compared";
}

TEST_F(FlipOnDevice, IsShownInMagma) {
  const FrameResult result = draw(Arrangement::flip, {"off", "blend"});
  const Image expected = magma(flip(seen(result.delivered[1].picture), seen(result.delivered[2].picture)));
  const std::vector<uint8_t>& is = result.delivered[0].picture.rgba;
  ASSERT_EQ(is.size(), expected.rgba.size());
  // a step of 255 of an error is up to four of a channel
  for (size_t i = 0; i < is.size(); ++i) ASSERT_NEAR(is[i], expected.rgba[i], 4) << i;
}

TEST_F(FlipOnDevice, IsMadeOfThePicturesAtAnySizeOfTheWindow) {
  for (const glm::ivec2 window : {glm::ivec2(480, 270), {200, 113}, {37, 23}}) {
    const Image same = draw(Arrangement::flip, {"blend", "blend"}, window).delivered[0].picture;
    const Image other = draw(Arrangement::flip, {"off", "blend"}, window).delivered[0].picture;
    EXPECT_EQ(other.width, uint32_t(window.x));
    for (size_t i = 0; i < same.rgba.size(); ++i)
      ASSERT_EQ(same.rgba[i], i % 4 == 3 ? 255 : 0) << "no error at " << i;
    const auto whole = draw(Arrangement::flip, {"off", "blend"}).delivered[0].picture.rgba;
    const auto mean = [](const std::vector<uint8_t>& rgba) {
      double sum = 0;
      for (size_t i = 0; i < rgba.size(); i += 4) sum += rgba[i];
      return sum / double(rgba.size() / 4);
    };
    EXPECT_NEAR(mean(other.rgba), mean(whole), 0.1 * mean(whole)) << "the same errors";
  }
}

} // namespace
} // namespace unghost
