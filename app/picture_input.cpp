#include "app/picture_input.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_HDR
#define STBI_NO_STDIO
#include <stb/stb_image.h>

#include "app/command_line.h"
#include "app/failure.h"
#include "app/files.h"
#include "app/measure/flip.h"
#include "app/png_file.h"

namespace unghost {
namespace {

constexpr size_t most_bytes = size_t(1) << 31;

struct Unreadable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

bool begins_with(const std::vector<uint8_t>& bytes, std::string_view magic) {
  return bytes.size() >= magic.size() && std::equal(magic.begin(), magic.end(), bytes.begin(),
                                                    [](char a, uint8_t b) { return uint8_t(a) == b; });
}

void check_size(int64_t width, int64_t height) {
  if (width < 1 || height < 1 || width > longest_side || height > longest_side ||
      uint64_t(width) * uint64_t(height) > most_picture_pixels)
    throw Unreadable("its size is " + std::to_string(width) + "x" + std::to_string(height) +
                     ", and neither side may exceed " + std::to_string(longest_side));
}

/// OpenEXR's view of bytes in memory.
class Bytes : public Imf::IStream {
public:
  explicit Bytes(const std::vector<uint8_t>& bytes) : IStream("picture"), bytes_(bytes) {}
  bool read(char to[], int count) override {
    if (count < 0 || size_t(count) > bytes_.size() - at_) throw Unreadable("it ends too early");
    std::copy_n(bytes_.begin() + std::ptrdiff_t(at_), count, to);
    at_ += size_t(count);
    return at_ < bytes_.size();
  }
  uint64_t tellg() override { return at_; }
  void seekg(uint64_t to) override {
    if (to > bytes_.size()) throw Unreadable("it ends too early");
    at_ = to;
  }

private:
  const std::vector<uint8_t>& bytes_;
  size_t at_ = 0;
};

FloatImage read_exr(const std::vector<uint8_t>& bytes) {
  Bytes stream(bytes);
  Imf::InputFile file(stream, 1);
  const Imath::Box2i window = file.header().dataWindow();
  const int64_t width = int64_t(window.max.x) - window.min.x + 1,
                height = int64_t(window.max.y) - window.min.y + 1;
  check_size(width, height);
  const Imf::ChannelList& channels = file.header().channels();
  const bool coloured = channels.findChannel("R") != nullptr;
  if (!coloured && channels.findChannel("Y") == nullptr) throw Unreadable("it has neither R, G and B nor Y");
  FloatImage image{.width = uint32_t(width), .height = uint32_t(height), .channels = 3, .values = {}};
  image.values.resize(size_t(width) * size_t(height) * 3);
  constexpr size_t pixel = 3 * sizeof(float);
  const size_t row = pixel * size_t(width);
  Imf::FrameBuffer frame;
  const std::string names[] = {coloured ? "R" : "Y", "G", "B"};
  for (size_t c = 0; c < (coloured ? 3u : 1u); ++c) {
    // The library adds the window's corner to what it is given.
    char* first = reinterpret_cast<char*>(image.values.data() + c);
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, first, window, pixel, row));
  }
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  if (!coloured)
    for (size_t i = 0; i < image.values.size(); i += 3)
      image.values[i + 1] = image.values[i + 2] = image.values[i];
  return image;
}

FloatImage read_hdr(const std::vector<uint8_t>& bytes) {
  int width = 0, height = 0, channels = 0;
  const auto size = int(bytes.size());
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) != 0) check_size(width, height);
  const std::unique_ptr<float, void (*)(void*)> pixels(
      stbi_loadf_from_memory(bytes.data(), size, &width, &height, &channels, 3), stbi_image_free);
  if (pixels == nullptr) throw Unreadable(stbi_failure_reason());
  return {uint32_t(width), uint32_t(height), 3,
          std::vector<float>(pixels.get(), pixels.get() + size_t(width) * size_t(height) * 3)};
}

LinearPicture decoded(const std::vector<uint8_t>& bytes) {
  if (begins_with(bytes, "\x76\x2f\x31\x01")) return {read_exr(bytes), true};
  if (begins_with(bytes, "#?")) return {read_hdr(bytes), true};
  if (!is_png(bytes)) throw Unreadable("it is no PNG, OpenEXR or Radiance HDR picture");
  return {linear_from_srgb(decode_png(bytes)), false};
}

} // namespace

LinearPicture read_picture(const std::filesystem::path& path) {
  const std::vector<uint8_t> bytes = read_file(path, most_bytes);
  const auto refuse = [&path](const std::string& why) {
    return Failure(Exit::input_refused, path.string() + ": " + why);
  };
  LinearPicture picture;
  try {
    picture = decoded(bytes);
  } catch (const Failure&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) { // ours, libpng's and OpenEXR's
    throw refuse(error.what());
  }
  for (const float value : picture.image.values)
    if (!std::isfinite(value)) throw refuse("a pixel is not a number, or infinite");
  return picture;
}

} // namespace unghost
