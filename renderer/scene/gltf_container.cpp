#include "renderer/scene/gltf_container.h"

#include <cstring>
#include <string>

#include "renderer/scene/gltf_report.h"

namespace unghost::gltf {

namespace {

constexpr uint32_t chunk_json = 0x4E4F534A, chunk_bin = 0x004E4942;

struct Chunk {
  uint32_t type = 0;
  std::span<const uint8_t> data;
};

uint32_t little_endian(std::span<const uint8_t> bytes, size_t at) {
  return uint32_t(bytes[at]) | uint32_t(bytes[at + 1]) << 8 | uint32_t(bytes[at + 2]) << 16 |
         uint32_t(bytes[at + 3]) << 24;
}

/// Takes one chunk off the front of `rest`.
Chunk next_chunk(std::span<const uint8_t>& rest) {
  if (rest.size() < 8) refuse("the .glb ends inside a chunk header");
  const uint32_t length = little_endian(rest, 0);
  const Chunk chunk{little_endian(rest, 4), rest.subspan(8, std::min<size_t>(length, rest.size() - 8))};
  if (length > rest.size() - 8) {
    refuse("a .glb chunk says it has " + std::to_string(length) + " bytes, and " +
           std::to_string(rest.size() - 8) + " are left");
  }
  rest = rest.subspan(8 + length);
  return chunk;
}

std::string_view text_of(std::span<const uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Container open_glb(std::span<const uint8_t> bytes) {
  if (bytes.size() < 12) refuse("the .glb ends inside its header");
  const uint32_t version = little_endian(bytes, 4), length = little_endian(bytes, 8);
  if (version != 2) refuse("is a .glb of version " + std::to_string(version) + "; only 2 is read");
  if (length != bytes.size()) {
    refuse("the .glb says it has " + std::to_string(length) + " bytes, and it has " +
           std::to_string(bytes.size()));
  }
  std::span<const uint8_t> rest = bytes.subspan(12);
  const Chunk first = next_chunk(rest);
  if (first.type != chunk_json) refuse("the first chunk of the .glb is not JSON");
  Container container{.json = text_of(first.data), .is_glb = true, .binary = {}};
  // What follows the second chunk belongs to extensions and is skipped, but a second BIN is a broken file.
  for (int i = 1; !rest.empty(); ++i) {
    const Chunk chunk = next_chunk(rest);
    if (chunk.type == chunk_json) refuse("the .glb has two JSON chunks");
    if (chunk.type != chunk_bin) continue;
    if (i != 1) refuse("the .glb has a BIN chunk that is not its second chunk");
    container.binary = chunk.data;
  }
  return container;
}

} // namespace

Container open_container(std::span<const uint8_t> bytes) {
  if (bytes.empty()) refuse("the file is empty");
  if (bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0) return open_glb(bytes);
  std::string_view text = text_of(bytes);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '{') refuse("is neither glTF's JSON nor a .glb");
  return {.json = text, .is_glb = false, .binary = {}};
}

} // namespace unghost::gltf
