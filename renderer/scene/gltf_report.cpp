#include "renderer/scene/gltf_report.h"

namespace unghost::gltf {

namespace {
constexpr size_t longest_name = 80;
constexpr size_t most_warnings = 50;
} // namespace

void refuse(std::string why, std::string pointer) { throw Refused{std::move(pointer), std::move(why)}; }

std::string printable(std::string_view text) {
  std::string out(text.substr(0, longest_name));
  for (char& c : out) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text.size() > longest_name ? out + "..." : out;
}

std::string pointer_to(std::string_view collection, size_t index, std::string_view field) {
  std::string out = "/" + std::string(collection) + "/" + std::to_string(index);
  return field.empty() ? out : out + "/" + std::string(field);
}

void Warnings::say(const std::string& sentence) {
  if (known_.size() > most_warnings || !known_.insert(sentence).second) return;
  said_.push_back(known_.size() > most_warnings ? "there is more that is not said here" : sentence);
}

} // namespace unghost::gltf
