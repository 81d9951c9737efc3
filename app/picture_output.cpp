#include "app/picture_output.h"

#include "app/failure.h"

namespace unghost {

PictureOutput::PictureOutput(const CommandLine& line, Console& console)
    : name_(line.output), out_(console.out) {
  if (name_ != "-") {
    if (!name_.ends_with(".png") && !name_.ends_with(".exr") && name_.rfind("/dev/", 0) != 0)
      throw WrongWords("a picture's name ends in .png or .exr, not '" + name_ + "'");
    file_ = std::make_unique<NewFile>(name_);
  } else if (line.json) {
    throw WrongWords("--json and -o - both write to standard output");
  }
}

void PictureOutput::write(std::span<const uint8_t> bytes) {
  if (file_) {
    file_->write(bytes);
    file_->commit();
    return;
  }
  out_.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  out_.flush();
  if (!out_) throw Failure(Exit::failed, "cannot write to standard output");
}

} // namespace unghost
