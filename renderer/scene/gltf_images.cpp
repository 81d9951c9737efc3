#include "renderer/scene/gltf_images.h"

#include "renderer/scene/gltf_uri.h"

namespace unghost::gltf {

namespace {

size_t count_of(const Json& document) {
  const auto images = document.find("images");
  return images == document.end() ? 0 : images->size();
}

std::string name_of(const Json& json, int image) {
  if (json.contains("name")) return json.at("name").get<std::string>();
  if (json.contains("uri")) {
    const auto& uri = json.at("uri").get_ref<const std::string&>();
    if (!is_data_uri(uri)) return uri;
  }
  return "image " + std::to_string(image);
}

} // namespace

Images::Images(const Sources& from, const LoadLimits& limits)
    : from_(from), bounds_{limits.image_side, limits.decoded_bytes}, places_(count_of(from.document), -1) {
  for (size_t i = 0; i < places_.size(); ++i) {
    const Json& json = from_.document["images"][i];
    if (!json.contains("uri")) continue;
    if (json.contains("bufferView")) refuse("has both a URI and a view", pointer_to("images", i));
    const auto& uri = json.at("uri").get_ref<const std::string&>();
    if (!is_data_uri(uri)) path_of_uri(uri, pointer_to("images", i, "uri"));
  }
}

int Images::use(int image) {
  int& place = image < 0 ? without_source_ : places_[size_t(image)];
  if (place >= 0) return place;
  place = int(decoded_.size());
  if (image < 0) {
    from_.warnings.say("a texture without an image is drawn as a checkerboard");
    decoded_.push_back(checkerboard());
  } else {
    decoded_.push_back(decode(image));
  }
  return place;
}

Image Images::decode(int image) {
  const Json& json = from_.document.at("images")[size_t(image)];
  const std::string name = name_of(json, image);
  Image decoded;
  try {
    const std::vector<uint8_t> bytes = bytes_of(json, image);
    decoded = decode_picture(bytes, bounds_);
  } catch (const std::runtime_error& problem) { // FileProblem or BrokenPicture
    from_.warnings.say("the picture '" + printable(name) +
                       "' is drawn as a checkerboard: " + printable(problem.what()));
    decoded = checkerboard();
  }
  decoded.name = name;
  return decoded;
}

std::vector<uint8_t> Images::bytes_of(const Json& json, int image) {
  const std::string pointer = pointer_to("images", size_t(image));
  if (json.contains("bufferView")) {
    const std::span<const uint8_t> bytes =
        from_.accessors.bytes_of_view(json.at("bufferView").get<size_t>(), pointer);
    return {bytes.begin(), bytes.end()};
  }
  if (!json.contains("uri")) throw BrokenPicture("it has neither a URI nor a view");
  const auto& uri = json.at("uri").get_ref<const std::string&>();
  if (!is_data_uri(uri)) return from_.folder.read(path_of_uri(uri, pointer + "/uri"), pointer + "/uri");
  std::optional<std::vector<uint8_t>> bytes = decode_data_uri(uri);
  if (!bytes) throw BrokenPicture("its data: URI is malformed");
  return std::move(*bytes);
}

} // namespace unghost::gltf
