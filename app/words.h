// Commands as lines of text that a POSIX shell reads as the same words. No line is ever given to a shell
// here.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unghost {

using Words = std::vector<std::string>;

/// With blanks between them, in single quotes where a shell would read them otherwise. Throws
/// std::invalid_argument for a word with a line break, which no line holds.
std::string quoted_words(std::span<const std::string> words);
/// The words of a line as a shell takes them apart: blanks, both kinds of quotes and backslashes. Throws
/// std::invalid_argument with what is wrong for whatever a shell would do more about: `$`, a backtick, `;`,
/// `|`, a redirection, a pattern, a comment.
Words words_of_line(std::string_view line);

/// What is asked for, and where it is to be written.
struct AskedWords {
  Words words;        // but for -o and its value
  std::string output; // empty where there is no -o
};
AskedWords apart_from_output(const Words& words);

} // namespace unghost
