// Other programs, run by a test. No shell is between.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace unghost {

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The first word is found by PATH; the child runs in `folder`, talks into the file `talk` and prints to the
/// open file `output`, where they are given. Never returns in the child.
inline pid_t start(const std::vector<std::string>& words, const std::filesystem::path& folder = {},
                   const std::filesystem::path& talk = {}, int output = -1) {
  const pid_t child = fork();
  if (child != 0) return child;
  if (!talk.empty()) {
    const int file = open(talk.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (file < 0 || dup2(file, STDERR_FILENO) < 0) _exit(126);
  }
  if (output >= 0 && dup2(output, STDOUT_FILENO) < 0) _exit(126);
  std::vector<char*> pointers;
  for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  if (folder.empty() || chdir(folder.c_str()) == 0) execvp(pointers[0], pointers.data());
  _exit(127);
}

/// The exit code; 128 + the signal where one ended it.
inline int wait_for(pid_t child) {
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

inline int exit_of(const std::vector<std::string>& words, const std::filesystem::path& folder = {}) {
  return wait_for(start(words, folder));
}

} // namespace unghost
