#include "app/exr_file.h"

#include <new>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include "app/failure.h"

namespace unghost {

std::vector<uint8_t> encode_exr(const std::vector<ExrChannel>& channels, const std::string& text) {
  const int width = int(channels.front().image->width), height = int(channels.front().image->height);
  Imf::Header header(width, height);
  header.compression() = Imf::ZIP_COMPRESSION;
  header.insert("unghost", Imf::StringAttribute(text));
  Imf::FrameBuffer frame;
  for (const ExrChannel& channel : channels) {
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    const size_t pixel = channel.image->channels * sizeof(float);
    // The writer only reads; its interface has no const.
    char* base =
        reinterpret_cast<char*>(const_cast<float*>(channel.image->values.data() + channel.component));
    frame.insert(channel.name, Imf::Slice(Imf::FLOAT, base, pixel, pixel * size_t(width)));
  }
  try {
    Imf::StdOSStream stream;
    {
      Imf::OutputFile file(stream, header, 1);
      file.setFrameBuffer(frame);
      file.writePixels(height);
    }
    const std::string bytes = stream.str();
    return {bytes.begin(), bytes.end()};
  } catch (const std::bad_alloc&) {
    throw; // is told as such
  } catch (const std::exception& error) {
    throw Failure(Exit::failed, std::string("OpenEXR could not encode the images: ") + error.what());
  }
}

} // namespace unghost
