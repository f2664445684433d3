#include "robot/body/sim/pacer.h"

#include "sim/math/tick.h"

namespace robot::body {

void Pacer::restart(double speed, std::uint64_t now_ns) {
  speed_ = speed;
  period_ns_ = static_cast<double>(kSecond) / (static_cast<double>(sim::kTicksPerSecond) * speed);
  start_ns_ = now_ns;
  taken_ = 0;
}

std::uint64_t Pacer::due_ns(std::uint64_t tick) const {
  return start_ns_ + static_cast<std::uint64_t>(static_cast<double>(tick) * period_ns_);
}

std::uint64_t Pacer::take(std::uint64_t now_ns) {
  const std::uint64_t late_ns = now_ns - next_ns();
  if (late_ns > kPatienceNs) {
    const auto given_up = static_cast<std::uint64_t>(static_cast<double>(late_ns - kPatienceNs) / period_ns_);
    ticks_behind_ += given_up;
    start_ns_ += static_cast<std::uint64_t>(static_cast<double>(given_up) * period_ns_);
  }
  return due_ns(++taken_);
}

}  // namespace robot::body
