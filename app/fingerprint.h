// A short name for much content: FNV-1a (Fowler, Noll and Vo 1991), 64 bits. Not against those who mean harm.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace unghost {

class Fingerprint {
public:
  void add(std::span<const uint8_t> bytes) {
    for (const uint8_t byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3u;
  }
  /// And its end, so that "ab", "c" is not "a", "bc".
  void add(std::string_view text) {
    for (const char c : text) hash_ = (hash_ ^ uint8_t(c)) * 0x100000001b3u;
    hash_ = (hash_ ^ 0xff) * 0x100000001b3u;
  }
  /// The last `digits` of 16, which the content changes most.
  std::string hex(size_t digits) const {
    std::string text;
    for (size_t i = digits; i-- > 0;) text += "0123456789abcdef"[hash_ >> (4 * i) & 15];
    return text;
  }

private:
  uint64_t hash_ = 0xcbf29ce484222325u;
};

} // namespace unghost
