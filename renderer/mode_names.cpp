#include "renderer/mode_names.h"

#include <algorithm>

namespace unghost {

std::string base_of_mode(std::string_view name) { return std::string(name.substr(0, name.find(':'))); }

std::vector<std::string> changes_of_mode(std::string_view name) {
  std::vector<std::string> changes;
  for (size_t colon = name.find(':'); colon != std::string_view::npos;) {
    const size_t next = name.find(':', colon + 1);
    std::string& change = changes.emplace_back(name.substr(colon + 1, next - colon - 1));
    std::ranges::replace(change, '+', ',');
    colon = next;
  }
  return changes;
}

bool changes_only_jitter(std::string_view name) {
  return base_of_mode(name) != name &&
         std::ranges::all_of(changes_of_mode(name),
                             [](const std::string& change) { return change.starts_with("jitter"); });
}

bool mode_says(std::string_view name, std::string_view setting) {
  return std::ranges::any_of(changes_of_mode(name), [&](const std::string& change) {
    return change.substr(0, change.find('=')) == setting;
  });
}

} // namespace unghost
