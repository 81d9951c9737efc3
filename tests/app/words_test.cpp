#include "app/words.h"

#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/app/child.h"
#include "tests/app/scratch_folder.h"

namespace unghost {
namespace {

const Words nasty = {"",
                     " ",
                     "a b",
                     "a  b\t",
                     "'",
                     "''",
                     "it's",
                     "\"",
                     "\\",
                     "\\\\'\"",
                     "$HOME",
                     "`id`",
                     "$(id)",
                     "a;b",
                     "a|b",
                     "a>b",
                     "<b",
                     "a&",
                     "*",
                     "?",
                     "[a]",
                     "{}",
                     "{#}",
                     "{a,b}",
                     "~",
                     "~root",
                     "#a",
                     "a#b",
                     "!",
                     "!!",
                     "^a",
                     "=ls",
                     "-n",
                     "--",
                     "%s",
                     "alpha=0.05",
                     "a=~",
                     "\x01\x7f\x1b[31m",
                     "grün/テスト.glb",
                     "\xff\xfe"};

TEST(Words, PlainOnesStayAsTheyAre) {
  const Words words = {"unghost", "measure", "asphalt",    "--size", "640x360",   "--modes",
                       "a,b",     "--set",   "alpha=0.05", "-o",     "a-b_1.json"};
  EXPECT_EQ(quoted_words(words),
            "unghost measure asphalt --size 640x360 --modes a,b --set alpha=0.05 -o a-b_1.json");
  EXPECT_EQ(quoted_words(Words{"it's", ""}), "'it'\\''s' ''");
}

TEST(Words, ALineIsTakenApartAgain) {
  EXPECT_EQ(words_of_line(quoted_words(nasty)), nasty);
  for (const std::string& word : nasty)
    EXPECT_EQ(words_of_line(quoted_words(Words{word})), Words{word}) << word;
  const std::string letters = " \t'\"\\$`;|<>&()*?[]{}~#!=ab\x80";
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round) {
    Words words(1 + random() % 4);
    for (std::string& word : words)
      for (size_t i = random() % 8; i > 0; --i) word += letters[random() % letters.size()];
    ASSERT_EQ(words_of_line(quoted_words(words)), words) << quoted_words(words);
  }
}

TEST(Words, AShellReadsTheSame) {
  const ScratchFolder folder;
  std::string script = "printf '%s\\0' " + quoted_words(nasty) + " >" + (folder.path / "out").string();
  EXPECT_EQ(exit_of({"sh", folder.file("script", script).string()}), 0);
  std::string expected;
  for (const std::string& word : nasty) expected += word + '\0';
  EXPECT_EQ(content_of(folder.path / "out"), expected);
}

TEST(Words, CommonQuotesAreUnderstood) {
  EXPECT_EQ(words_of_line(""), Words{});
  EXPECT_EQ(words_of_line(" \t "), Words{});
  EXPECT_EQ(words_of_line("a  \"b c\"\t'd e' f\\ g"), (Words{"a", "b c", "d e", "f g"}));
  EXPECT_EQ(words_of_line(R"("a\"b" "c\d" "\$\`\\" x"y"'z' "")"), (Words{"a\"b", "c\\d", "$`\\", "xyz", ""}));
}

TEST(Words, WhatAShellWouldDoMoreAboutIsRefused) {
  for (const char* line : {"a $b", "a `b`", "a; b", "a & b", "a | b",  "a > b", "a < b", "a >> b", "$(a)",
                           "a *",  "a ?",   "[a]",  "{a,b}", "~/a",    "a # b", "!a",    "\"$a\"", "\"`a`\"",
                           "'a",   "\"a",   "a\\",  "a\nb",  "'a\nb'", "a\r",   "a\x01"})
    EXPECT_THROW(words_of_line(line), std::invalid_argument) << line;
  EXPECT_THROW(words_of_line(std::string("a\0b", 3)), std::invalid_argument);
  EXPECT_THROW(quoted_words(Words{"a\nb"}), std::invalid_argument);
}

} // namespace
} // namespace unghost
