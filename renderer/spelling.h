// How the answers of shaders/shared/*.h are spelled outside the program: `closest_depth` is `closest-depth`.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace unghost {

/// One enumerator: its spelling and its value.
struct Answer {
  std::string name;
  uint32_t value = 0;
};

/// Every answer of a column, in the order of its list; the enums of taa_modes.h, View, Stage and Arrangement
/// have one. A set of flags has no entry for the empty set.
template <class Column> std::span<const Answer> answers();

/// The spelling of one answer; empty for a value that is none.
template <class Column> std::string_view spelling(Column value) {
  for (const Answer& answer : answers<Column>())
    if (answer.value == uint32_t(value)) return answer.name;
  return {};
}

std::string joined(std::span<const std::string> words, std::string_view between);
/// The known word nearest to `word` by edit distance; empty where none is near.
std::string nearest_word(std::string_view word, std::span<const std::string> known);
/// `; did you mean 'x'?`, or nothing where no known word is near.
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

} // namespace unghost
