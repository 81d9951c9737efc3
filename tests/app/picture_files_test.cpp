#include <cmath>
#include <fstream>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <gtest/gtest.h>
#include <png.h>

#include "app/exr_file.h"
#include "app/png_file.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

Image noise(uint32_t width, uint32_t height) {
  Image image{.name = "", .width = width, .height = height, .rgba = {}};
  uint32_t state = 1;
  for (size_t i = 0; i < size_t(width) * height; ++i) {
    for (int c = 0; c < 3; ++c) image.rgba.push_back(uint8_t((state = state * 1664525u + 1013904223u) >> 24));
    image.rgba.push_back(255);
  }
  return image;
}

TEST(Png, HoldsThePicture) {
  for (const auto& [width, height] : {std::pair{1u, 1u}, {37u, 5u}}) {
    const Image picture = noise(width, height);
    const std::vector<uint8_t> bytes = encode_png(picture, "{}");
    png_image read{};
    read.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_memory(&read, bytes.data(), bytes.size()));
    read.format = PNG_FORMAT_RGBA;
    std::vector<uint8_t> rgba(PNG_IMAGE_SIZE(read));
    ASSERT_TRUE(png_image_finish_read(&read, nullptr, rgba.data(), 0, nullptr));
    EXPECT_EQ(read.width, width);
    EXPECT_EQ(rgba, picture.rgba);
  }
}

TEST(Png, CarriesItsTextAndIsTheSameEachTime) {
  const std::string text = R"({"scene":"Straße.glb","alpha":0.1})";
  const std::vector<uint8_t> bytes = encode_png(noise(8, 8), text);
  EXPECT_TRUE(is_png(bytes));
  EXPECT_EQ(text_in_png(bytes), text);
  EXPECT_EQ(encode_png(noise(8, 8), text), bytes);
}

TEST(Png, ABrokenOneHasNoText) {
  std::vector<uint8_t> bytes = encode_png(noise(8, 8), "{}");
  EXPECT_FALSE(is_png({}));
  for (const size_t size : {size_t(0), size_t(7), size_t(8), size_t(20), size_t(40)})
    EXPECT_EQ(text_in_png(std::span(bytes).first(size)), std::nullopt) << size;
  for (size_t i = 8; i < 60; ++i) {
    std::vector<uint8_t> damaged = bytes;
    damaged[i] ^= 0xFF;
    text_in_png(damaged); // comes back
  }
}

TEST(Exr, HoldsTheChannelsAndTheText) {
  const FloatImage colour{.width = 3,
                          .height = 2,
                          .channels = 3,
                          .values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 70000, 13, 14, 15, 16, 17, 18}};
  const FloatImage depth{.width = 3, .height = 2, .channels = 1, .values = {1, 2, 3, 4, 5, INFINITY}};
  const std::vector<uint8_t> bytes =
      encode_exr({{"R", &colour, 0}, {"B", &colour, 2}, {"Z", &depth, 0}}, "{\"a\":1}");
  const ScratchFolder folder;
  const auto path = folder.file("a.exr", {bytes.begin(), bytes.end()});
  Imf::InputFile file(path.c_str());
  EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("unghost").value(), "{\"a\":1}");
  std::vector<float> blue(6), z(6);
  Imf::FrameBuffer frame;
  const auto slice = [](std::vector<float>& to) {
    return Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(to.data()), sizeof(float), 3 * sizeof(float));
  };
  frame.insert("B", slice(blue));
  frame.insert("Z", slice(z));
  file.setFrameBuffer(frame);
  file.readPixels(0, 1);
  EXPECT_EQ(blue, (std::vector<float>{3, 6, 9, 70000, 15, 18}));
  EXPECT_EQ(z, depth.values);
}

} // namespace
} // namespace unghost
