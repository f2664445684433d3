#include "robot/logging/streams/bell.h"

#include <mutex>

#include "robot/core/report.h"
#include "robot/core/thread.h"

namespace robot::logging {

Bell::~Bell() {
  {
    const std::lock_guard guard(lock_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void Bell::add(Sleeper& sleeper) {
  const std::lock_guard guard(lock_);
  sleepers_.push_back(&sleeper);
  start();
  changed_.notify_all();
}

void Bell::start_missing_thread() {
  const std::lock_guard guard(lock_);
  if (!sleepers_.empty()) start();
}

/// Starts the thread if there is none. Called with the lock.
void Bell::start() {
  if (thread_.joinable()) return;
  if (const Result<void> started = start_thread(thread_, "log bell", [this] { run(); }); !started)
    report(Level::error, "logging", started.error() + "; all versions wait");
}

void Bell::remove(Sleeper& sleeper) {
  const std::lock_guard guard(lock_);
  std::erase(sleepers_, &sleeper);
}

void Bell::run() {
  become_background_thread("log bell");
  std::unique_lock guard(lock_);
  while (!ended_) {
    if (sleepers_.empty()) {
      changed_.wait(lock_);
      continue;
    }
    const std::uint64_t now = monotonic_ns();
    for (Sleeper* sleeper : sleepers_) sleeper->ring(now);
    const std::uint64_t next = now + kPeriodNs;
    while (!ended_ && monotonic_ns() < next) changed_.wait_until(lock_, next);
  }
}

}  // namespace robot::logging
