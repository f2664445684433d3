#include "robot/logging/sessions/job_thread.h"

#include <algorithm>
#include <mutex>

#include "robot/core/attempt.h"
#include "robot/core/clock.h"
#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::logging {

JobThread::~JobThread() {
  {
    const std::lock_guard guard(lock_);
    ended_ = true;
    changed_.notify_all();
  }
  if (thread_.joinable()) thread_.join();
}

void JobThread::add(const std::vector<std::string>& names, std::uint64_t wait_ns) {
  const std::uint64_t until_ns = monotonic_ns() + wait_ns;
  std::unique_lock guard(lock_);
  if (!thread_.joinable()) {
    if (const Result<void> started = start_thread(thread_, "sessions", [this] { run(); }); !started) {
      guard.unlock();
      for (const std::string& name : names) job_(name);
      return;
    }
  }
  for (const std::string& name : names)
    if (std::ranges::find(waiting_, name) == waiting_.end()) waiting_.push_back(name);
  changed_.notify_all();
  while (!is_done(names) && monotonic_ns() < until_ns) changed_.wait_until(lock_, until_ns);
}

bool JobThread::is_done(const std::vector<std::string>& names) const {
  return std::ranges::none_of(names, [&](const std::string& name) {
    return name == present_ || std::ranges::find(waiting_, name) != waiting_.end();
  });
}

void JobThread::run() {
  become_background_thread("sessions");
  std::unique_lock guard(lock_);
  while (true) {
    while (waiting_.empty() && !ended_) changed_.wait(lock_);
    if (ended_) return;
    present_ = std::move(waiting_.front());
    waiting_.pop_front();

    guard.unlock();
    const Result<void> done = attempt("reading a session", [&] { job_(present_); });
    if (!done) report(Level::error, "logging", done.error());
    guard.lock();

    present_.clear();
    changed_.notify_all();
  }
}

}  // namespace robot::logging
