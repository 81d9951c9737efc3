#include "renderer/scene/gltf_pictures.h"

#include "tests/scene/picture_files.h"

namespace unghost::test {
namespace {

using gltf::BrokenPicture;
using gltf::PictureBounds;

Image decode(const Bytes& file) {
  PictureBounds bounds{.side = 64, .bytes_left = 1 << 20};
  return gltf::decode_picture(file, bounds);
}

TEST(Pictures, png_of_every_kind_becomes_rgba) {
  EXPECT_EQ(decode(png_file({.width = 2, .height = 1, .rows = {1, 2, 3, 4, 5, 6}})).rgba,
            (Bytes{1, 2, 3, 255, 4, 5, 6, 255}));
  EXPECT_EQ(decode(png_file({.width = 1,
                             .height = 2,
                             .colour_type = PNG_COLOR_TYPE_RGBA,
                             .rows = {1, 2, 3, 4, 5, 6, 7, 8}}))
                .rgba,
            (Bytes{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(
      decode(png_file({.width = 2, .height = 1, .colour_type = PNG_COLOR_TYPE_GRAY, .rows = {7, 9}})).rgba,
      (Bytes{7, 7, 7, 255, 9, 9, 9, 255}));
  EXPECT_EQ(
      decode(png_file({.width = 1, .height = 1, .colour_type = PNG_COLOR_TYPE_GRAY_ALPHA, .rows = {7, 9}}))
          .rgba,
      (Bytes{7, 7, 7, 9}));
  EXPECT_EQ(
      decode(
          png_file({.width = 2, .height = 1, .colour_type = PNG_COLOR_TYPE_GRAY, .bits = 1, .rows = {0x40}}))
          .rgba,
      (Bytes{0, 0, 0, 255, 255, 255, 255, 255}));
  EXPECT_EQ(
      decode(png_file({.width = 1, .height = 1, .bits = 16, .rows = {0xff, 0xff, 0x80, 0x80, 0, 1}})).rgba,
      (Bytes{255, 128, 0, 255}));
  EXPECT_EQ(decode(png_file({.width = 2,
                             .height = 1,
                             .colour_type = PNG_COLOR_TYPE_PALETTE,
                             .rows = {1, 0},
                             .palette = {{10, 20, 30}, {40, 50, 60}},
                             .palette_alpha = {128}}))
                .rgba,
            (Bytes{40, 50, 60, 255, 10, 20, 30, 128}));
}

TEST(Pictures, interlaced_png_is_whole) {
  Bytes rows(16 * 16 * 3);
  for (size_t i = 0; i < rows.size(); ++i) rows[i] = uint8_t(i * 7);
  const Bytes plain = decode(png_file({.width = 16, .height = 16, .rows = rows})).rgba;
  EXPECT_EQ(decode(png_file({.width = 16, .height = 16, .interlaced = true, .rows = rows})).rgba, plain);
}

TEST(Pictures, jpeg_in_colour_and_gray) {
  const Image colour = decode(jpeg_file(9, 5, 3, JCS_RGB, 200));
  EXPECT_EQ(colour.width, 9u);
  EXPECT_EQ(colour.height, 5u);
  ASSERT_EQ(colour.rgba.size(), 9u * 5 * 4);
  EXPECT_NEAR(colour.rgba[0], 200, 2);
  EXPECT_EQ(colour.rgba[3], 255);
  EXPECT_NEAR(decode(jpeg_file(4, 4, 1, JCS_GRAYSCALE, 77)).rgba[1], 77, 2);
}

TEST(Pictures, cut_off_files_are_broken_at_every_length) {
  for (const Bytes& whole :
       {png_file({.width = 8, .height = 8, .rows = Bytes(192, 9)}), jpeg_file(8, 8, 3, JCS_RGB, 9)}) {
    for (size_t size = 0; size + 2 < whole.size(); ++size) {
      EXPECT_THROW(decode({whole.begin(), whole.begin() + ptrdiff_t(size)}), BrokenPicture) << size;
    }
  }
}

TEST(Pictures, size_is_bounded_by_the_header) {
  const Bytes wide = png_file({.width = 65, .height = 1, .rows = Bytes(195)});
  EXPECT_THROW(decode(wide), BrokenPicture);
  EXPECT_THROW(decode(jpeg_file(1, 65, 3, JCS_RGB, 0)), BrokenPicture);
  PictureBounds bounds{.side = 64, .bytes_left = 64 * 64 * 4 + 15};
  const Bytes small = png_file({.rows = Bytes(12)});
  EXPECT_NO_THROW(
      gltf::decode_picture(png_file({.width = 64, .height = 64, .rows = Bytes(64 * 64 * 3)}), bounds));
  EXPECT_THROW(gltf::decode_picture(small, bounds), BrokenPicture); // 16 bytes do not fit into 15
}

TEST(Pictures, others_are_not_guessed_at) {
  EXPECT_THROW(decode({}), BrokenPicture);
  EXPECT_THROW(decode({'G', 'I', 'F', '8', '9', 'a', 0, 0}), BrokenPicture);
  EXPECT_THROW(decode({'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'E', 'B', 'P'}), BrokenPicture);
}

TEST(Pictures, come_from_files_views_and_data_uris) {
  const Bytes png = png_file({.rows = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}});
  Document document;
  document.json["images"] = {{{"uri", "a picture%2Bmore.png"}},
                             {{"uri", "data:image/png;base64," + base64(png)}},
                             {{"bufferView", document.view(png)}, {"mimeType", "image/jpeg"}}};
  document.json["textures"] = {{{"source", 0}}, {{"source", 1}}, {{"source", 2}}};
  for (int i = 0; i < 3; ++i) document.add("materials", {{"emissiveTexture", {{"index", i}}}});
  const TempFolder folder;
  folder.write("a picture+more.png", png);
  const Scene scene = scene_of(load_scene(folder.write("scene.gltf", document.text())));
  EXPECT_TRUE(scene.warnings.empty());
  ASSERT_EQ(scene.images.size(), 3u);
  for (const Image& image : scene.images) {
    EXPECT_EQ(image.rgba, (Bytes{1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255, 10, 11, 12, 255}));
  }
}

} // namespace
} // namespace unghost::test
