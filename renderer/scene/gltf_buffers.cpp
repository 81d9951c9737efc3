#include "renderer/scene/gltf_accessors.h"
#include "renderer/scene/gltf_uri.h"

namespace unghost::gltf {

namespace {

Buffer buffer_from_uri(const std::string& uri, Folder& folder, const std::string& pointer) {
  Buffer buffer;
  if (is_data_uri(uri)) {
    std::optional<std::vector<uint8_t>> bytes = decode_data_uri(uri);
    if (!bytes) refuse("its data: URI is malformed", pointer);
    buffer.owned = std::move(*bytes);
  } else {
    const std::string path = path_of_uri(uri, pointer);
    try {
      buffer.owned = folder.read(path, pointer);
    } catch (const FileProblem& problem) {
      refuse("its file '" + printable(path) + "': " + problem.what(), pointer);
    }
  }
  buffer.bytes = buffer.owned;
  return buffer;
}

} // namespace

void Accessors::load_buffers(const Json& document, const Container& container, Folder& folder,
                             const LoadLimits& limits) {
  const auto buffers = document.find("buffers");
  if (buffers == document.end()) return;
  buffers_.reserve(buffers->size());
  uint64_t total = 0;
  for (size_t i = 0; i < buffers->size(); ++i) {
    const Json& json = (*buffers)[i];
    const auto length = json.at("byteLength").get<uint64_t>();
    const std::string pointer = pointer_to("buffers", i);
    Buffer buffer;
    if (json.contains("uri")) {
      buffer = buffer_from_uri(json.at("uri").get_ref<const std::string&>(), folder, pointer + "/uri");
    } else if (i == 0 && container.is_glb) {
      if (!container.binary) refuse("has neither a URI nor a BIN chunk", pointer);
      buffer.bytes = container.binary;
    }
    if (buffer.bytes && buffer.bytes->size() < length) {
      refuse("has " + std::to_string(buffer.bytes->size()) + " bytes, fewer than it says",
             pointer + "/byteLength");
    }
    total += buffer.owned.size();
    if (total > limits.read_bytes) refuse("its buffers have too many bytes together", pointer);
    buffer_lengths_.push_back(length);
    buffers_.push_back(std::move(buffer));
  }
}

} // namespace unghost::gltf
