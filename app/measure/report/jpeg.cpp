#include "app/measure/report/jpeg.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

#include <jpeglib.h>

namespace unghost {
namespace {

struct Compressor {
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;

  // libjpeg's own handler ends the process: for memory that ran out, the only error that writing to memory
  // has
  Compressor() {
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    jpeg_mem_dest(&jpeg, &bytes, &size);
  }
  ~Compressor() {
    jpeg_destroy_compress(&jpeg);
    std::free(bytes);
  }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
};

} // namespace

std::vector<uint8_t> encode_jpeg(const Image& picture, int quality) {
  Compressor to;
  to.jpeg.image_width = picture.width, to.jpeg.image_height = picture.height;
  to.jpeg.input_components = 3, to.jpeg.in_color_space = JCS_RGB;
  jpeg_set_defaults(&to.jpeg);
  jpeg_set_quality(&to.jpeg, quality, TRUE);
  to.jpeg.optimize_coding = TRUE;
  to.jpeg.comp_info[0].h_samp_factor = to.jpeg.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&to.jpeg, TRUE);
  std::vector<uint8_t> row(size_t(picture.width) * 3);
  for (uint32_t y = 0; y < picture.height; ++y) {
    const uint8_t* from = picture.rgba.data() + size_t(y) * picture.width * 4;
    for (size_t x = 0; x < picture.width; ++x)
      for (size_t c = 0; c < 3; ++c) row[3 * x + c] = from[4 * x + c];
    JSAMPROW line = row.data();
    jpeg_write_scanlines(&to.jpeg, &line, 1);
  }
  jpeg_finish_compress(&to.jpeg);
  return {to.bytes, to.bytes + to.size};
}

} // namespace unghost
