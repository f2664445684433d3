#include "robot/body/replay/playback_clock.h"

#include <algorithm>
#include <mutex>

namespace robot::body {

void PlaybackClock::start() {
  const std::lock_guard guard(lock_);
  running_ = true;
  started_ns_ = monotonic_ns();
  changed_.notify_all();
}

void PlaybackClock::stop() {
  const std::lock_guard guard(lock_);
  running_ = false;
  changed_.notify_all();
}

std::uint64_t PlaybackClock::now_ns() const {
  const std::lock_guard guard(lock_);
  if (!running_) return started_ns_ == 0 ? start_ns_ : end_ns_;
  const double played_ns = static_cast<double>(monotonic_ns() - started_ns_) * speed_;
  return start_ns_ + static_cast<std::uint64_t>(std::min(played_ns, static_cast<double>(end_ns_ - start_ns_)));
}

/// When on the monotonic clock a message is due. Messages older than the recording's start are due at once.
std::uint64_t PlaybackClock::due_ns(std::uint64_t capture_ns) const {
  const double played_ns = static_cast<double>(std::max(capture_ns, start_ns_) - start_ns_);
  return started_ns_ + static_cast<std::uint64_t>(played_ns / speed_);
}

bool PlaybackClock::wait_until_due(std::uint64_t capture_ns) {
  const std::lock_guard guard(lock_);
  while (running_ && monotonic_ns() < due_ns(capture_ns)) changed_.wait_until(lock_, due_ns(capture_ns));
  return running_;
}

}  // namespace robot::body
