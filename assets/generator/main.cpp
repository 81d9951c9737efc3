// author-assets [FOLDER]: writes the scenes into FOLDER (default: assets).
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "assets/generator/author.h"

namespace {

// Whole or not at all: a reader never sees half a file.
void write_file(const std::filesystem::path& file, const std::vector<uint8_t>& bytes) {
  const std::filesystem::path part = file.string() + ".part";
  std::ofstream out(part, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  out.close();
  if (!out) {
    std::filesystem::remove(part);
    throw std::runtime_error("cannot write " + file.string() + ": does its folder exist, and is there room?");
  }
  std::filesystem::rename(part, file);
}

} // namespace

int main(int count, char** arguments) {
  try {
    const std::filesystem::path folder = count > 1 ? arguments[1] : "assets";
    write_file(folder / "asphalt.glb", unghost::author::author_asphalt());
    return 0;
  } catch (const std::exception& problem) {
    std::cerr << "author-assets: " << problem.what() << '\n';
    return 1;
  }
}
