// The program as it is built, run under conditions that a test sets.
#pragma once

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/app/child.h"
#include "tests/app/own_copy.h"
#include "tests/app/scratch_folder.h"

namespace unghost {

using Words = std::vector<std::string>;

/// How a run ended, and what it said on standard error.
struct Ended {
  int exit;
  std::string talk;
};

inline Words operator+(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Small enough to be drawn in no time.
inline const Words small_capture = {"capture", "--size", "64x36", "--frames", "3", "-q", "-o"};

/// Sanitized runs are slow enough, and what they draw is validated by other tests.
inline const Words unvalidated = {"env", "UNGHOST_VALIDATE=0"};

class ProgramTest : public testing::Test {
protected:
  static std::string program() { return (folder_of_this_program() / "unghost").string(); }

  std::string at(const std::string& name) const { return (folder_.path / name).string(); }
  /// `under` are the words of programs that set the conditions and then run the rest: env, prlimit.
  Ended run(const Words& words, const Words& under = {}) const {
    const std::string talk = (talk_.path / "talk").string();
    const int exit = wait_for(start(unvalidated + under + Words{program()} + words, folder_.path, talk));
    return {exit, content_of(talk)};
  }
  /// What a run that nothing disturbs writes to `name`.
  std::string undisturbed(Words words, const std::string& name) const {
    const ScratchFolder apart;
    const std::string file = (apart.path / name).string();
    words.push_back(file);
    const Ended ended = run(words);
    EXPECT_EQ(ended.exit, 0) << ended.talk;
    return content_of(file);
  }

  const ScratchFolder folder_, talk_;
};

/// One sentence of the program's, with these words in it.
inline void expect_sentence(const Ended& ended, const std::vector<std::string>& parts) {
  EXPECT_TRUE(ended.talk.starts_with("unghost: ")) << ended.talk;
  EXPECT_EQ(std::ranges::count(ended.talk, '\n'), 1) << ended.talk;
  for (const std::string& part : parts)
    EXPECT_NE(ended.talk.find(part), std::string::npos) << "no '" << part << "' in " << ended.talk;
}

} // namespace unghost
