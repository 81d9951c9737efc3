#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include <jerror.h>

#include "renderer/scene/gltf_pictures.h"

namespace unghost::gltf {

namespace {

// A progressive file may repeat scans for ever: each costs a pass over the whole picture. Encoders write
// about ten.
constexpr int most_scans = 32;
constexpr long library_memory = 768L << 20;

struct Reader {
  jpeg_decompress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg_progress_mgr progress{};
  std::jmp_buf on_error;
  char problem[JMSG_LENGTH_MAX] = "it is broken";

  ~Reader() { jpeg_destroy_decompress(&jpeg); }
};

Reader* reader_of(j_common_ptr jpeg) { return static_cast<Reader*>(jpeg->client_data); }

[[noreturn]] void leave(j_common_ptr jpeg) {
  Reader* reader = reader_of(jpeg);
  jpeg->err->format_message(jpeg, reader->problem);
  std::longjmp(reader->on_error, 1);
}

void on_message(j_common_ptr jpeg, int level) {
  // A file or a scan that ends too early would be filled with gray, at length; other warnings are about
  // details.
  const int code = jpeg->err->msg_code;
  if (level < 0 && (code == JWRN_JPEG_EOF || code == JWRN_HIT_MARKER)) leave(jpeg);
}

void on_progress(j_common_ptr jpeg) {
  Reader* reader = reader_of(jpeg);
  if (reader->jpeg.input_scan_number <= most_scans) return;
  std::snprintf(reader->problem, sizeof reader->problem, "it has more than %d scans", most_scans);
  std::longjmp(reader->on_error, 1);
}

// libjpeg leaves by longjmp. The frames it leaves own nothing: whoever owns is above them.

bool read_header(Reader& reader, std::span<const uint8_t> bytes) {
  if (setjmp(reader.on_error)) return false;
  jpeg_create_decompress(&reader.jpeg);
  reader.jpeg.client_data = &reader;
  reader.jpeg.progress = &reader.progress;
  reader.jpeg.mem->max_memory_to_use = library_memory;
  jpeg_mem_src(&reader.jpeg, bytes.data(), bytes.size());
  jpeg_read_header(&reader.jpeg, TRUE);
  return true;
}

bool read_rows(Reader& reader, uint8_t* rgba) {
  if (setjmp(reader.on_error)) return false;
  reader.jpeg.out_color_space = JCS_EXT_RGBA;
  jpeg_start_decompress(&reader.jpeg);
  while (reader.jpeg.output_scanline < reader.jpeg.output_height) {
    JSAMPROW row = rgba + size_t(reader.jpeg.output_scanline) * reader.jpeg.output_width * 4;
    jpeg_read_scanlines(&reader.jpeg, &row, 1);
  }
  jpeg_finish_decompress(&reader.jpeg);
  return true;
}

} // namespace

Image decode_jpeg(std::span<const uint8_t> bytes, PictureBounds& bounds) {
  Reader reader;
  reader.jpeg.err = jpeg_std_error(&reader.errors);
  reader.jpeg.client_data = &reader;
  reader.errors.error_exit = leave;
  reader.errors.emit_message = on_message;
  reader.progress.progress_monitor = on_progress;
  if (!read_header(reader, bytes)) throw BrokenPicture(reader.problem);
  Image image{.name = {}, .width = reader.jpeg.image_width, .height = reader.jpeg.image_height, .rgba = {}};
  bounds.take(image.width, image.height);
  image.rgba.resize(size_t(image.width) * image.height * 4);
  if (!read_rows(reader, image.rgba.data())) throw BrokenPicture(reader.problem);
  return image;
}

} // namespace unghost::gltf
