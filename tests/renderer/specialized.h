// What is left of a shader once its specialization constants are known: what the driver gets to see.
#pragma once

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

#include "renderer/gpu/specialize.h"

namespace unghost {

/// Instructions that read or write images, by the binding of the image in set 0.
struct Specialized {
  std::map<uint32_t, int> reads, writes;
  size_t instructions = 0;
  size_t logarithms = 0;
};

inline std::vector<uint32_t> words_of(const std::filesystem::path& file) {
  std::vector<uint32_t> words(std::filesystem::file_size(file) / 4);
  std::ifstream(file, std::ios::binary)
      .read(reinterpret_cast<char*>(words.data()), std::streamsize(words.size() * 4));
  return words;
}

inline Specialized contents_of(const std::filesystem::path& file, const std::vector<uint32_t>& constants) {
  enum : uint32_t {
    ext_inst = 12,
    load = 61,
    decorate = 71,
    image_fetch = 95,
    image_read = 98,
    image_write = 99
  };
  constexpr uint32_t sample_explicit_lod = 88, binding = 33, glsl_log = 28;
  const std::vector<uint32_t> words = specialized(words_of(file), constants);
  Specialized result;
  std::map<uint32_t, uint32_t> binding_of, variable_of;
  for (size_t at = 5; at < words.size(); at += words[at] >> 16) {
    const uint32_t* operand = &words[at + 1];
    ++result.instructions;
    switch (words[at] & 0xffff) {
    case decorate:
      if (operand[1] == binding) binding_of[operand[0]] = operand[2];
      break;
    case load:
      variable_of[operand[1]] = operand[2];
      break;
    case ext_inst:
      if (operand[3] == glsl_log) ++result.logarithms;
      break;
    case image_fetch:
    case image_read:
    case sample_explicit_lod:
      ++result.reads[binding_of.at(variable_of.at(operand[2]))];
      break;
    case image_write:
      ++result.writes[binding_of.at(variable_of.at(operand[0]))];
      break;
    default:
      break;
    }
  }
  return result;
}

} // namespace unghost
