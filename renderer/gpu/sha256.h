// SHA-256 (FIPS 180-4): whether a file is what was built.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace unghost {

class Sha256 {
public:
  static std::string hex(std::string_view text) {
    Sha256 sum;
    std::string padded(text);
    padded += '\x80';
    while (padded.size() % 64 != 56) padded += '\0';
    for (int shift = 56; shift >= 0; shift -= 8) padded += char(uint64_t(text.size()) * 8 >> shift);
    for (size_t at = 0; at < padded.size(); at += 64) sum.block(std::string_view(padded).substr(at, 64));
    std::string digits;
    for (const uint32_t word : sum.state_)
      for (int shift = 28; shift >= 0; shift -= 4) digits += "0123456789abcdef"[word >> shift & 15];
    return digits;
  }

private:
  /// The first 32 bits of the fraction of a root of the n-th prime.
  static uint32_t root(int n, double power) {
    int prime = 1;
    for (int found = 0; found <= n;) {
      ++prime;
      bool is_prime = true;
      for (int divisor = 2; divisor * divisor <= prime; ++divisor)
        is_prime = is_prime && prime % divisor != 0;
      found += is_prime ? 1 : 0;
    }
    const long double value = powl(prime, power == 2 ? 1.0L / 2 : 1.0L / 3);
    return uint32_t((value - floorl(value)) * 4294967296.0L);
  }
  void block(std::string_view bytes) {
    static const auto constants = [] {
      std::array<uint32_t, 64> k{};
      for (int i = 0; i < 64; ++i) k[size_t(i)] = root(i, 3);
      return k;
    }();
    std::array<uint32_t, 64> w{};
    for (size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | uint8_t(bytes[i]);
    for (size_t i = 16; i < 64; ++i)
      w[i] = (std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ w[i - 2] >> 10) + w[i - 7] +
             (std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ w[i - 15] >> 3) + w[i - 16];
    auto [a, b, c, d, e, f, g, h] = state_;
    for (size_t i = 0; i < 64; ++i) {
      const uint32_t one = h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) +
                           ((e & f) ^ (~e & g)) + constants[i] + w[i];
      const uint32_t two =
          (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
      h = g, g = f, f = e, e = d + one, d = c, c = b, b = a, a = one + two;
    }
    const std::array<uint32_t, 8> now = {a, b, c, d, e, f, g, h};
    for (size_t i = 0; i < 8; ++i) state_[i] += now[i];
  }

  std::array<uint32_t, 8> state_ = {root(0, 2), root(1, 2), root(2, 2), root(3, 2),
                                    root(4, 2), root(5, 2), root(6, 2), root(7, 2)};
};

} // namespace unghost
