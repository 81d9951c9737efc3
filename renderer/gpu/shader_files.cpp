#include "renderer/gpu/shader_files.h"

#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "renderer/gpu/sha256.h"

namespace unghost {
namespace {

constexpr std::string_view extension = ".spv";

std::string read(const std::filesystem::path& file, const char* what) {
  std::ifstream in(file, std::ios::binary);
  std::stringstream bytes;
  if (!in || !(bytes << in.rdbuf()))
    throw std::runtime_error(what + (" " + file.string()) + " is missing or empty; build again");
  return bytes.str();
}

std::map<std::string, std::string> read_sums(const std::filesystem::path& folder) {
  std::istringstream lines(read(folder / list_of_sums, "the list of shaders"));
  std::map<std::string, std::string> sums;
  for (std::string sum, file; lines >> sum >> file;) sums[file] = sum;
  return sums;
}

/// Drivers don't survive shaders that are damaged, nor does what makes them faster: they see those that were
/// built.
std::vector<uint32_t> read_spirv(const std::filesystem::path& file, const std::string& sum) {
  const std::string bytes = read(file, "the shader");
  if (Sha256::hex(bytes) != sum)
    throw std::runtime_error("the shader " + file.string() + " is not what was built; build again");
  std::vector<uint32_t> words(bytes.size() / sizeof(uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint32_t));
  return words;
}

} // namespace

const std::vector<uint32_t>& ShaderFiles::spirv(const std::string& file) {
  auto found = spirv_.find(file);
  if (found == spirv_.end()) {
    if (sums_.empty()) sums_ = read_sums(folder_);
    const std::string name = file + std::string(extension);
    found = spirv_.emplace(file, read_spirv(folder_ / name, sums_[name])).first;
  }
  return found->second;
}

void ShaderFiles::read_all() {
  if (sums_.empty()) sums_ = read_sums(folder_);
  for (const auto& [name, sum] : sums_)
    if (name.ends_with(extension)) spirv(name.substr(0, name.size() - extension.size()));
}

} // namespace unghost
