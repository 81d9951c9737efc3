#include "renderer/scene/gltf_json.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace unghost::gltf {

namespace {

constexpr std::array drawn_extensions{
    std::string_view("KHR_texture_transform"),   std::string_view("KHR_materials_unlit"),
    std::string_view("KHR_materials_clearcoat"), std::string_view("KHR_materials_emissive_strength"),
    std::string_view("KHR_lights_punctual"),     std::string_view("KHR_mesh_quantization")};

/// Skips a string; `at` is on its first quote, and on its last afterwards.
size_t end_of_string(std::string_view text, size_t at) {
  for (++at; at < text.size() && text[at] != '"'; ++at) {
    if (text[at] == '\\') ++at;
  }
  return at;
}

void check_size(std::string_view text, const LoadLimits& limits) {
  // Every value but the first of its array or object follows a comma.
  std::vector<uint32_t> items(limits.json_depth + 1, 0);
  uint64_t values = 0;
  uint32_t depth = 0;
  for (size_t at = 0; at < text.size(); ++at) {
    switch (text[at]) {
    case '"':
      at = end_of_string(text, at);
      break;
    case '[':
    case '{':
      if (++depth > limits.json_depth) {
        refuse("its JSON is more than " + std::to_string(limits.json_depth) + " deep");
      }
      items[depth] = 1, ++values;
      break;
    case ']':
    case '}':
      depth -= depth > 0;
      break;
    case ',':
      ++values;
      if (++items[depth] > limits.elements) {
        refuse("its JSON has more than " + std::to_string(limits.elements) + " elements of one kind");
      }
      break;
    default:
      break;
    }
  }
  // A parsed value takes up to a hundred bytes, so the total is bounded too.
  if (values > 8ull * limits.elements) refuse("its JSON has more than 8 values for each element allowed");
}

struct Version {
  int major = 0, minor = 0;
  auto operator<=>(const Version&) const = default;
};

Version version_of(const Json& asset, const char* field) {
  const std::string pointer = std::string("/asset/") + field;
  const auto it = asset.find(field);
  if (it == asset.end() || !it->is_string())
    refuse("asset." + std::string(field) + " is no version", pointer);
  const std::string& text = it->get_ref<const std::string&>();
  Version version;
  const char* end = text.data() + text.size();
  const auto major = std::from_chars(text.data(), end, version.major);
  bool good = major.ec == std::errc() && major.ptr != end && *major.ptr == '.';
  if (good) {
    const auto minor = std::from_chars(major.ptr + 1, end, version.minor);
    good = minor.ec == std::errc() && minor.ptr == end;
  }
  if (!good) refuse("'" + printable(text) + "' is no version", pointer);
  return version;
}

void check_version(const Json& document) {
  const auto asset = document.find("asset");
  if (asset == document.end() || !asset->is_object()) {
    refuse("it does not say which version of glTF it is (glTF 2.0 has asset.version)", "/asset");
  }
  const Version version = version_of(*asset, "version");
  const auto said = [](Version v) { return std::to_string(v.major) + "." + std::to_string(v.minor); };
  if (version.major != 2) refuse("is glTF " + said(version) + "; only 2.x is read", "/asset/version");
  if (!asset->contains("minVersion")) return;
  const Version least = version_of(*asset, "minVersion");
  if (least > Version{2, 0}) refuse("needs glTF " + said(least) + "; 2.0 is read", "/asset/minVersion");
}

void check_extensions(const Json& document, Warnings& warnings) {
  const auto is_drawn = [](const std::string& name) {
    return std::find(drawn_extensions.begin(), drawn_extensions.end(), name) != drawn_extensions.end();
  };
  for (const char* list : {"extensionsRequired", "extensionsUsed"}) {
    const auto names = document.find(list);
    if (names == document.end()) continue;
    if (!names->is_array()) refuse("is not an array", std::string("/") + list);
    for (size_t i = 0; i < names->size(); ++i) {
      if (!(*names)[i].is_string()) refuse("is not a string", pointer_to(list, i));
      const std::string& name = (*names)[i].get_ref<const std::string&>();
      if (is_drawn(name)) continue;
      if (std::string_view(list) == "extensionsRequired") {
        refuse("needs the extension " + printable(name) + ", which is not supported", pointer_to(list, i));
      }
      warnings.say("the extension " + printable(name) + " is not supported and left out");
    }
  }
}

} // namespace

Json parse_json(std::string_view text, const LoadLimits& limits, Warnings& warnings) {
  if (text.starts_with("\xEF\xBB\xBF")) refuse("its JSON chunk begins with a byte order mark");
  check_size(text, limits);
  Json document;
  try {
    document = Json::parse(text);
  } catch (const Json::exception& error) {
    refuse(std::string("is not valid JSON: ") + printable(error.what()));
  }
  if (!document.is_object()) refuse("its JSON is not an object");
  check_version(document);
  check_extensions(document, warnings);
  return document;
}

} // namespace unghost::gltf
