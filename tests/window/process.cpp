#include "tests/window/process.h"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include <poll.h>
#include <sys/resource.h>

namespace unghost {

using Clock = std::chrono::steady_clock;

Process::Process(const Words& words, const std::filesystem::path& talk) : talk_(talk) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  Words bound = {"setpriv", "--pdeathsig", "TERM"};
  bound.insert(bound.end(), words.begin(), words.end());
  child_ = start(bound, {}, talk, ends[1]);
  close(ends[1]);
  output_ = ends[0];
  if (child_ < 0) throw std::runtime_error("no process for " + words.front());
}

Process::~Process() {
  signal(SIGTERM);
  if (!exit_code(Milliseconds(5000))) {
    signal(SIGKILL);
    exit_code();
  }
  close(output_);
}

bool Process::read_more(Clock::time_point until) {
  const auto left = std::chrono::duration_cast<Milliseconds>(until - Clock::now()).count();
  pollfd output = {output_, POLLIN, 0};
  if (poll(&output, 1, int(std::max<int64_t>(left, 0))) <= 0) return false;
  char bytes[4096];
  const ssize_t count = read(output_, bytes, sizeof(bytes));
  if (count > 0) unread_.append(bytes, size_t(count));
  return count > 0;
}

std::optional<std::string> Process::line(Milliseconds limit) {
  const auto until = Clock::now() + limit;
  size_t end;
  while ((end = unread_.find('\n')) == std::string::npos)
    if (!read_more(until)) return std::nullopt;
  const std::string found = unread_.substr(0, end);
  unread_.erase(0, end + 1);
  return found;
}

std::string Process::rest() {
  while (read_more(Clock::now() + patience)) {
  }
  return std::exchange(unread_, {});
}

std::optional<int> Process::exit_code(Milliseconds limit) {
  const auto until = Clock::now() + limit;
  while (!exit_code_) {
    siginfo_t ended = {};
    waitid(P_PID, id_t(child_), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid == child_)
      exit_code_ = wait_for(child_);
    else if (Clock::now() > until)
      break;
    else
      std::this_thread::sleep_for(Milliseconds(2));
  }
  return exit_code_;
}

void Process::signal(int number) const {
  if (!exit_code_) kill(child_, number);
}

void Process::limit_files(std::optional<uint64_t> bytes) const {
  rlimit limit{};
  prlimit(child_, RLIMIT_FSIZE, nullptr, &limit);
  limit.rlim_cur = bytes ? rlim_t(*bytes) : limit.rlim_max; // which can be raised again
  if (prlimit(child_, RLIMIT_FSIZE, &limit, nullptr) != 0)
    throw std::runtime_error(std::string("its files cannot be limited: ") + std::strerror(errno));
}

} // namespace unghost
