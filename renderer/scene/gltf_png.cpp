#include <csetjmp>
#include <cstring>

#include <png.h>

#include "renderer/scene/gltf_pictures.h"

namespace unghost::gltf {

namespace {

struct Reader {
  std::span<const uint8_t> rest;
  char problem[120] = "it is broken";
  png_structp png = nullptr;
  png_infop info = nullptr;

  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void on_error(png_structp png, png_const_charp message) {
  auto* reader = static_cast<Reader*>(png_get_error_ptr(png));
  std::strncpy(reader->problem, message, sizeof reader->problem - 1);
  png_longjmp(png, 1);
}

void on_warning(png_structp, png_const_charp) {}

void give_bytes(png_structp png, png_bytep out, size_t size) {
  auto* reader = static_cast<Reader*>(png_get_io_ptr(png));
  if (size > reader->rest.size()) png_error(png, "it ends too early");
  std::memcpy(out, reader->rest.data(), size);
  reader->rest = reader->rest.subspan(size);
}

// libpng leaves by longjmp. The frames it leaves own nothing: whoever owns is above them.

bool read_header(Reader& reader, uint32_t side) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_read_fn(reader.png, &reader, give_bytes);
  png_set_user_limits(reader.png, side, side);
  png_set_chunk_malloc_max(reader.png, 1 << 20); // text and profiles inflate too
  png_read_info(reader.png, reader.info);
  return true;
}

bool read_rows(Reader& reader, uint8_t** rows) {
  if (setjmp(png_jmpbuf(reader.png))) return false;
  png_set_expand(reader.png);
  png_set_scale_16(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_add_alpha(reader.png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  if (png_get_rowbytes(reader.png, reader.info) != 4 * size_t(png_get_image_width(reader.png, reader.info))) {
    return false;
  }
  png_read_image(reader.png, rows);
  png_read_end(reader.png, nullptr);
  return true;
}

} // namespace

Image decode_png(std::span<const uint8_t> bytes, PictureBounds& bounds) {
  Reader reader{.rest = bytes};
  reader.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader, on_error, on_warning);
  reader.info = reader.png ? png_create_info_struct(reader.png) : nullptr;
  if (!reader.info) throw BrokenPicture("there is no memory for it");
  // libpng checks the side itself too, but in its own words.
  constexpr uint32_t largest = 0x7fffffff;
  if (!read_header(reader, largest)) throw BrokenPicture(reader.problem);
  Image image{.name = {},
              .width = png_get_image_width(reader.png, reader.info),
              .height = png_get_image_height(reader.png, reader.info),
              .rgba = {}};
  bounds.take(image.width, image.height);
  image.rgba.resize(size_t(image.width) * image.height * 4);
  std::vector<uint8_t*> rows(image.height);
  for (size_t y = 0; y < rows.size(); ++y) rows[y] = &image.rgba[y * image.width * 4];
  if (!read_rows(reader, rows.data())) throw BrokenPicture(reader.problem);
  return image;
}

} // namespace unghost::gltf
