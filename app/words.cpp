#include "app/words.h"

#include <algorithm>
#include <stdexcept>

namespace unghost {
namespace {

constexpr std::string_view letters_and_digits =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
constexpr std::string_view plain_marks = "_@%+=:,./-"; // that no shell reads anything into, in an argument
constexpr std::string_view of_the_shell = "$`;&|<>()*?[]{}~#!";

bool is_plain(char c) {
  return letters_and_digits.find(c) != std::string_view::npos ||
         plain_marks.find(c) != std::string_view::npos;
}

/// Bytes beyond ASCII are parts of letters.
bool is_control(char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }

class LineReader {
public:
  explicit LineReader(std::string_view line) : rest_(line) {}

  Words words() {
    while (skip_blanks()) words_.push_back(word());
    return std::move(words_);
  }

private:
  bool skip_blanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
    return !rest_.empty();
  }

  char take() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  std::string word() {
    std::string word;
    while (!rest_.empty() && rest_.front() != ' ' && rest_.front() != '\t') {
      const char c = take();
      if (c == '\'')
        word += in_single_quotes();
      else if (c == '"')
        word += in_double_quotes();
      else if (c == '\\')
        word += escaped();
      else
        word += bare(c);
    }
    return word;
  }

  std::string in_single_quotes() {
    const size_t end = rest_.find('\'');
    if (end == std::string_view::npos) throw std::invalid_argument("a single quote is not closed");
    const std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return text;
  }

  /// A backslash stands for itself there, but before what it would keep from its meaning.
  std::string in_double_quotes() {
    std::string text;
    while (!rest_.empty()) {
      char c = take();
      if (c == '"') return text;
      if (c == '$' || c == '`') refuse(c, "in double quotes");
      if (c == '\\' && !rest_.empty() && std::string_view("$`\"\\").find(rest_.front()) != std::string::npos)
        c = take();
      text += c;
    }
    throw std::invalid_argument("a double quote is not closed");
  }

  char escaped() {
    if (rest_.empty()) throw std::invalid_argument("it ends with a backslash");
    return take();
  }

  static char bare(char c) {
    if (of_the_shell.find(c) != std::string_view::npos) refuse(c, "outside quotes");
    if (is_control(c)) throw std::invalid_argument("it has a control character outside quotes");
    return c;
  }

  [[noreturn]] static void refuse(char c, const std::string& where) {
    throw std::invalid_argument("it has " + std::string(1, c) + " " + where + ", and is not for a shell");
  }

  std::string_view rest_;
  Words words_;
};

std::string quoted(const std::string& word) {
  if (word.find_first_of("\n\r") != std::string::npos || word.find('\0') != std::string::npos)
    throw std::invalid_argument("a word of a line has no line break");
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

} // namespace

std::string quoted_words(std::span<const std::string> words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + quoted(word);
  return line;
}

Words words_of_line(std::string_view line) {
  if (line.find_first_of("\n\r") != std::string_view::npos || line.find('\0') != std::string_view::npos)
    throw std::invalid_argument("it has a line break inside");
  return LineReader(line).words();
}

AskedWords apart_from_output(const Words& words) {
  AskedWords asked;
  for (size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word == "-o" || word == "--output")
      asked.output = ++i < words.size() ? words[i] : "";
    else if (word.starts_with("--output="))
      asked.output = word.substr(word.find('=') + 1);
    else if (word.starts_with("-o"))
      asked.output = word.substr(2);
    else
      asked.words.push_back(word);
  }
  return asked;
}

} // namespace unghost
