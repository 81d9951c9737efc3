// Encodes and writes files beside the rendering.
#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace unghost {

/// One thread that does what it is given, in order. A few may wait; then `add` does. A job's exception comes
/// out of the next `add` or of `finish`, and the jobs after it are dropped.
class WritingThread {
public:
  WritingThread();
  ~WritingThread();
  WritingThread(const WritingThread&) = delete;
  WritingThread& operator=(const WritingThread&) = delete;

  void add(std::function<void()> job);
  /// Waits until all is done.
  void finish();

private:
  void work();
  void rethrow();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> waiting_;
  std::exception_ptr fault_;
  bool busy_ = false, ending_ = false;
  std::thread thread_; // last: it starts when all else is there
};

} // namespace unghost
