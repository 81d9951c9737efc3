#include "renderer/scene/gltf_uri.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "renderer/scene/gltf_report.h"

namespace unghost::gltf {

namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> percent_decoded(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      out += text[i];
      continue;
    }
    const int high = i + 1 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = i + 2 < text.size() ? hex_digit(text[i + 2]) : -1;
    if (high < 0 || low < 0) return std::nullopt;
    out += char(high * 16 + low);
    i += 2;
  }
  return out;
}

int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return -1;
}

std::optional<std::vector<uint8_t>> base64_decoded(std::string_view text) {
  while (text.ends_with('=')) text.remove_suffix(1);
  if (text.size() % 4 == 1) return std::nullopt;
  std::vector<uint8_t> out;
  out.reserve(text.size() / 4 * 3 + 2);
  uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = base64_digit(c);
    if (digit < 0) return std::nullopt;
    bits = (bits << 6 | uint32_t(digit)) & 0xffffff;
    held += 6;
    if (held >= 8) out.push_back(uint8_t(bits >> (held -= 8)));
  }
  return out;
}

bool has_scheme(std::string_view uri) {
  const size_t colon = uri.find_first_of(":/?#");
  return colon != std::string_view::npos && uri[colon] == ':';
}

bool leaves_folder(std::string_view path) {
  int depth = 0;
  while (!path.empty()) {
    const size_t slash = std::min(path.find('/'), path.size());
    const std::string_view part = path.substr(0, slash);
    if (part == "..") {
      if (--depth < 0) return true;
    } else if (!part.empty() && part != ".") {
      ++depth;
    }
    path.remove_prefix(std::min(slash + 1, path.size()));
  }
  return false;
}

} // namespace

bool is_data_uri(std::string_view uri) {
  constexpr std::string_view scheme = "data:";
  return uri.size() >= scheme.size() &&
         std::equal(scheme.begin(), scheme.end(), uri.begin(),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

std::optional<std::vector<uint8_t>> decode_data_uri(std::string_view uri) {
  const size_t comma = uri.find(',');
  if (!is_data_uri(uri) || comma == std::string_view::npos) return std::nullopt;
  const std::string_view header = uri.substr(0, comma), body = uri.substr(comma + 1);
  if (header.ends_with(";base64")) return base64_decoded(body);
  const std::optional<std::string> text = percent_decoded(body);
  if (!text) return std::nullopt;
  return std::vector<uint8_t>(text->begin(), text->end());
}

std::string path_of_uri(std::string_view uri, const std::string& pointer) {
  const auto no = [&](const char* why) { refuse("the URI '" + printable(uri) + "' " + why, pointer); };
  if (has_scheme(uri)) no("has a scheme; only data: and files beside the scene are read");
  const std::optional<std::string> path = percent_decoded(uri);
  if (!path) no("is not percent-encoded as it should be");
  if (path->empty()) no("is empty");
  if (path->find('\0') != std::string::npos) no("has a NUL in it");
  if (path->find('\\') != std::string::npos) no("has a backslash in it");
  if (path->front() == '/') no("is an absolute path");
  if (leaves_folder(*path)) no("leaves the scene's folder");
  return *path;
}

} // namespace unghost::gltf
