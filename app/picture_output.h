// The one picture that a command is asked for: a file, or standard output.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "app/commands.h"
#include "app/files.h"

namespace unghost {

class PictureOutput {
public:
  /// Opens the file before the work. Throws WrongWords for `-` beside --json, which share standard output.
  PictureOutput(const CommandLine& line, Console& console);
  bool is_exr() const { return name_.ends_with(".exr"); }
  const std::string& name() const { return name_; }
  void write(std::span<const uint8_t> bytes);

private:
  std::string name_;
  std::ostream& out_;
  std::unique_ptr<NewFile> file_; // none for standard output
};

} // namespace unghost
