#include "robot/net/foxglove/worker.h"

#include <mutex>
#include <utility>

#include "robot/core/attempt.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::net {

Result<void> Worker::start() {
  return start_thread(thread_, name_, [this] { run(); });
}

void Worker::post(std::function<void()> task) {
  const std::lock_guard guard(lock_);
  if (finishing_) return;
  tasks_.push_back(std::move(task));
  changed_.notify_one();
}

void Worker::forget() {
  std::deque<std::function<void()>> forgotten;  // destroyed outside the lock
  const std::lock_guard guard(lock_);
  forgotten.swap(tasks_);
}

void Worker::finish() {
  {
    const std::lock_guard guard(lock_);
    finishing_ = true;
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
}

void Worker::run() {
  become_background_thread(name_);
  while (true) {
    std::function<void()> task;
    {
      std::unique_lock guard(lock_);
      while (tasks_.empty() && !finishing_) changed_.wait(lock_);
      if (tasks_.empty()) return;
      task = std::move(tasks_.front());
      tasks_.pop_front();
    }
    if (const Result<void> done = attempt(name_, task); !done) report(Level::error, "net", done.error());
    task = nullptr;  // its captures end before the wait
  }
}

}  // namespace robot::net
