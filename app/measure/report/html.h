// Text and data inside HTML, whatever they hold.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

namespace unghost {

/// For text and for attributes in double quotes.
std::string escaped(std::string_view text);
/// For the inside of a script element: there is no `<` in it. Bytes that are no UTF-8 are replaced.
std::string script_json(const nlohmann::json& data);
/// With that many decimals, whatever the locale.
std::string number(double value, int decimals);
/// What a reader has of it: the number that is written.
double as_read(double value, int decimals);
/// Three digits that count: 0.0213, 0.213, 21.3.
std::string milliseconds(double value);
std::string base64(std::span<const uint8_t> bytes);
/// `sha256-...` of a content security policy, from 64 hexadecimal digits.
std::string csp_hash(std::string_view sha256_hex);

} // namespace unghost
