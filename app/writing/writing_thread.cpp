#include "app/writing/writing_thread.h"

#include <utility>

namespace unghost {
namespace {

constexpr size_t most_waiting = 3; // a frame with buffers at 720p holds 40 MB

} // namespace

WritingThread::WritingThread() : thread_([this] { work(); }) {}

WritingThread::~WritingThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
    waiting_.clear();
  }
  changed_.notify_all();
  thread_.join();
}

void WritingThread::rethrow() {
  if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
}

void WritingThread::add(std::function<void()> job) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return waiting_.size() < most_waiting || fault_; });
  rethrow();
  waiting_.push_back(std::move(job));
  changed_.notify_all();
}

void WritingThread::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return (waiting_.empty() && !busy_) || fault_; });
  rethrow();
}

void WritingThread::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
    if (ending_) return;
    const std::function<void()> job = std::move(waiting_.front());
    waiting_.pop_front();
    busy_ = true;
    lock.unlock();
    std::exception_ptr fault;
    try {
      job();
    } catch (...) {
      fault = std::current_exception();
    }
    lock.lock();
    busy_ = false;
    if (fault) fault_ = fault, waiting_.clear();
    changed_.notify_all();
  }
}

} // namespace unghost
