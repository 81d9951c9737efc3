#include "app/measure/report/html.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <vector>

namespace unghost {

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) switch (c) {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    case '\'':
      safe += "&#39;";
      break;
    default:
      safe += c;
    }
  return safe;
}

std::string script_json(const nlohmann::json& data) {
  std::string safe;
  for (const char c : data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return safe;
}

std::string number(double value, int decimals) {
  char text[400]; // the largest double has 309 digits
  const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, decimals).ptr;
  return {text, end};
}

double as_read(double value, int decimals) {
  const std::string text = number(value, decimals);
  double read = value; // not a number stays so
  std::from_chars(text.data(), text.data() + text.size(), read);
  return read;
}

std::string milliseconds(double value) {
  if (!(value > 0)) return number(value, 0);
  return number(value, std::clamp(2 - int(std::floor(std::log10(value))), 0, 5));
}

std::string base64(std::span<const uint8_t> bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t rest = std::min<size_t>(3, bytes.size() - i);
    uint32_t three = uint32_t(bytes[i]) << 16;
    if (rest > 1) three |= uint32_t(bytes[i + 1]) << 8;
    if (rest > 2) three |= bytes[i + 2];
    for (size_t digit = 0; digit < 4; ++digit)
      text += digit <= rest ? digits[three >> (18 - 6 * digit) & 63] : '=';
  }
  return text;
}

std::string csp_hash(std::string_view sha256_hex) {
  std::vector<uint8_t> bytes;
  for (size_t i = 0; i + 1 < sha256_hex.size(); i += 2) {
    uint8_t byte = 0;
    std::from_chars(sha256_hex.data() + i, sha256_hex.data() + i + 2, byte, 16);
    bytes.push_back(byte);
  }
  assert(bytes.size() == 32);
  return "'sha256-" + base64(bytes) + "'";
}

} // namespace unghost
