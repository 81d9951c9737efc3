#include "app/png_file.h"

#include <csetjmp>
#include <cstring>
#include <new>

#include <png.h>

#include "app/failure.h"
#include "renderer/scene/gltf_pictures.h"

namespace unghost {
namespace {

// Measured on a frame of asphalt, 1280x720: 47 ms and 1.14 MB; libpng's defaults take 270 ms for 1.04 MB.
constexpr int zlib_level = 1;
constexpr int row_filter = PNG_FILTER_SUB;
constexpr char text_key[] = "unghost";
constexpr size_t text_limit = 1 << 20;

struct Sink {
  std::vector<uint8_t> bytes;
  bool full = false; // of memory

  bool take(const uint8_t* data, size_t size) {
    try {
      bytes.insert(bytes.end(), data, data + size);
    } catch (const std::bad_alloc&) { // must not pass through libpng
      full = true;
    }
    return !full;
  }
};

void append(png_structp png, png_bytep data, size_t size) {
  if (!static_cast<Sink*>(png_get_io_ptr(png))->take(data, size)) png_error(png, "no memory");
}

// libpng leaves by longjmp, so no object with a destructor lives in the functions that call it.
bool write_png(png_structp png, png_infop info, const Image& picture, const std::string& text, uint8_t* rgb) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_IHDR(png, info, picture.width, picture.height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_compression_level(png, zlib_level);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, row_filter);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_text chunk{};
  chunk.compression = PNG_ITXT_COMPRESSION_NONE;
  chunk.key = const_cast<char*>(text_key);
  chunk.text = const_cast<char*>(text.c_str());
  chunk.lang = const_cast<char*>("");
  chunk.lang_key = const_cast<char*>("");
  png_set_text(png, info, &chunk, 1);
  png_write_info(png, info);
  for (uint32_t y = 0; y < picture.height; ++y) {
    const uint8_t* rgba = picture.rgba.data() + size_t(y) * picture.width * 4;
    for (uint32_t x = 0; x < picture.width; ++x) std::memcpy(rgb + x * 3, rgba + x * 4, 3);
    png_write_row(png, rgb);
  }
  png_write_end(png, nullptr);
  return true;
}

void take(png_structp png, png_bytep data, size_t size) {
  auto& rest = *static_cast<std::span<const uint8_t>*>(png_get_io_ptr(png));
  if (size > rest.size()) png_error(png, "truncated");
  std::memcpy(data, rest.data(), size);
  rest = rest.subspan(size);
}

const char* find_text(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png))) return nullptr;
  png_set_user_limits(png, 65536, 65536);
  png_set_chunk_malloc_max(png, text_limit);
  png_read_info(png, info);
  png_textp chunks = nullptr;
  const int count = png_get_text(png, info, &chunks, nullptr);
  for (int i = 0; i < count; ++i)
    if (std::strcmp(chunks[i].key, text_key) == 0) return chunks[i].text;
  return nullptr;
}

void say_nothing(png_structp, png_const_charp) {}
void leave(png_structp png, png_const_charp) { png_longjmp(png, 1); }

} // namespace

std::vector<uint8_t> encode_png(const Image& picture, const std::string& text) {
  Sink sink;
  std::vector<uint8_t> row(size_t(picture.width) * 3);
  sink.bytes.reserve(size_t(picture.width) * picture.height * 2 + 4096);
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, say_nothing);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &sink, append, nullptr);
  const bool written = write_png(png, info, picture, text, row.data());
  png_destroy_write_struct(&png, &info);
  if (sink.full) throw std::bad_alloc();
  if (!written) throw Failure(Exit::failed, "libpng could not encode the picture");
  return std::move(sink).bytes;
}

Image decode_png(std::span<const uint8_t> bytes, uint32_t longest) {
  gltf::PictureBounds bounds{.side = longest, .bytes_left = 4 * most_picture_pixels};
  return gltf::decode_png(bytes, bounds);
}

bool is_png(std::span<const uint8_t> bytes) {
  return bytes.size() >= 8 && png_sig_cmp(bytes.data(), 0, 8) == 0;
}

std::optional<std::string> text_in_png(std::span<const uint8_t> bytes) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, say_nothing);
  png_infop info = png_create_info_struct(png);
  png_set_read_fn(png, &bytes, take);
  std::optional<std::string> text;
  if (const char* found = find_text(png, info)) text = found;
  png_destroy_read_struct(&png, &info, nullptr);
  return text;
}

} // namespace unghost
