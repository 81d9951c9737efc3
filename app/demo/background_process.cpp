#include "app/demo/background_process.h"

#include <algorithm>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "app/failure.h"

namespace unghost {
namespace {

constexpr size_t most_talk = 1 << 20; // bytes

/// How it begins: a group of its own, so that it can be ended with all that it starts, and none of the
/// signals that are ignored here.
class Beginning {
public:
  explicit Beginning(int output) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files_, output, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    sigset_t ignored;
    sigemptyset(&ignored);
    for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&ignored, signal);
    posix_spawnattr_setsigdefault(&attributes_, &ignored);
    posix_spawnattr_setpgroup(&attributes_, 0);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  }
  ~Beginning() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  Beginning(const Beginning&) = delete;
  Beginning& operator=(const Beginning&) = delete;

  int spawn(pid_t& child, const std::vector<std::string>& words) const {
    std::vector<char*> pointers;
    for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
    pointers.push_back(nullptr);
    return posix_spawn(&child, pointers[0], &files_, &attributes_, pointers.data(), environ);
  }

private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

[[noreturn]] void fail(const std::string& program, int why) {
  throw Failure(Exit::failed, "cannot run " + program + ": " + std::strerror(why));
}

} // namespace

BackgroundProcess::BackgroundProcess(const std::vector<std::string>& words) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0) fail(words.front(), errno);
  fcntl(ends[1], F_SETFL, 0); // who writes waits until it is read
  const int fault = Beginning(ends[1]).spawn(child_, words);
  close(ends[1]);
  if (fault != 0) {
    close(ends[0]);
    fail(words.front(), fault);
  }
  output_ = ends[0];
}

BackgroundProcess::~BackgroundProcess() {
  if (child_ > 0) {
    kill(-child_, SIGINT);
    waitpid(child_, nullptr, 0);
  }
  close(output_);
}

void BackgroundProcess::read_talk() {
  char bytes[4096];
  for (ssize_t count; (count = read(output_, bytes, sizeof(bytes))) > 0;)
    talk_.append(bytes, std::min(size_t(count), most_talk - talk_.size()));
}

std::optional<BackgroundProcess::End> BackgroundProcess::ended() {
  if (child_ <= 0) return {};
  int status = 0;
  const bool over = waitpid(child_, &status, WNOHANG) == child_;
  read_talk(); // after that: all of it is there
  if (!over) return {};
  child_ = -1;
  return End{.done = WIFEXITED(status) && WEXITSTATUS(status) == 0, .talk = std::move(talk_)};
}

} // namespace unghost
