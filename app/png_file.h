// Pictures as PNG, with what they were made from in a text chunk.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"

namespace unghost {

/// sRGB, 8 bits, alpha left out; `text` goes into an iTXt chunk with the key "unghost". The same bytes for
/// the same picture and text. Throws Failure(failed).
std::vector<uint8_t> encode_png(const Image& picture, const std::string& text);
constexpr uint64_t most_picture_pixels = uint64_t(1) << 28;
/// Any PNG with sides of at most `longest`, as 8-bit RGBA. Throws what says why it cannot be shown.
Image decode_png(std::span<const uint8_t> bytes, uint32_t longest = 16384);
bool is_png(std::span<const uint8_t> bytes);
/// The text that encode_png put in; nothing where there is none or the file is broken.
std::optional<std::string> text_in_png(std::span<const uint8_t> bytes);

} // namespace unghost
