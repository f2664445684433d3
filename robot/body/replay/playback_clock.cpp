#include "robot/body/replay/playback_clock.h"

#include <algorithm>
#include <mutex>

namespace robot::body {

std::uint64_t PlaybackClock::position_ns() const {
  if (!running_) return from_ns_;
  const double played_ns = static_cast<double>(monotonic_ns() - since_ns_) * speed_;
  return from_ns_ + static_cast<std::uint64_t>(std::min(played_ns, static_cast<double>(end_ns_ - from_ns_)));
}

void PlaybackClock::set_position(std::uint64_t position_ns) {
  from_ns_ = position_ns;
  since_ns_ = monotonic_ns();
  changed_.notify_all();
}

void PlaybackClock::start() { set(true, speed()); }

void PlaybackClock::stop() {
  const std::lock_guard guard(lock_);
  stopped_ = true;
  running_ = false;
  set_position(end_ns_);
}

void PlaybackClock::set(bool running, double speed) {
  const std::lock_guard guard(lock_);
  const std::uint64_t position = position_ns();
  running_ = running && !stopped_;
  speed_ = speed;
  set_position(position);
}

void PlaybackClock::seek(std::uint64_t to_ns) {
  const std::lock_guard guard(lock_);
  move_ = {.count = move_.count + 1, .to_ns = std::clamp(to_ns, start_ns_, end_ns_)};
  at_end_ = 0;
  set_position(move_.to_ns);
}

void PlaybackClock::look_again() {
  const std::lock_guard guard(lock_);
  move_ = {.count = move_.count + 1, .to_ns = position_ns()};
  at_end_ = 0;
  changed_.notify_all();
}

bool PlaybackClock::running() const {
  const std::lock_guard guard(lock_);
  return running_;
}

double PlaybackClock::speed() const {
  const std::lock_guard guard(lock_);
  return speed_;
}

std::size_t PlaybackClock::parsers_at_end() const {
  const std::lock_guard guard(lock_);
  return at_end_;
}

std::uint64_t PlaybackClock::now_ns() const {
  const std::lock_guard guard(lock_);
  return position_ns();
}

logging::Pace::Due PlaybackClock::wait_until_due(std::uint64_t capture_ns, std::uint64_t moves) {
  const std::lock_guard guard(lock_);
  const std::uint64_t wanted_ns = std::clamp(capture_ns, start_ns_, end_ns_);
  while (!stopped_ && move_.count == moves && position_ns() < wanted_ns) {
    const double ahead_ns = static_cast<double>(wanted_ns - from_ns_) / speed_;
    if (running_)
      changed_.wait_until(lock_, since_ns_ + static_cast<std::uint64_t>(ahead_ns) + 1);
    else
      changed_.wait(lock_);
  }
  if (stopped_) return Due::never;
  return move_.count == moves ? Due::now : Due::elsewhere;
}

logging::Pace::Due PlaybackClock::wait_for_move(std::uint64_t moves) {
  const std::lock_guard guard(lock_);
  if (move_.count == moves) ++at_end_;
  while (!stopped_ && move_.count == moves) changed_.wait(lock_);
  return stopped_ ? Due::never : Due::elsewhere;
}

logging::Pace::Move PlaybackClock::last_move() const {
  const std::lock_guard guard(lock_);
  return move_;
}

}  // namespace robot::body
