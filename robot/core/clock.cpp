#include "robot/core/clock.h"

#include <ctime>

namespace robot {
namespace {

std::uint64_t read(clockid_t id) {
  timespec time{};
  clock_gettime(id, &time);
  return static_cast<std::uint64_t>(time.tv_sec) * kSecond + static_cast<std::uint64_t>(time.tv_nsec);
}

}  // namespace

std::uint64_t monotonic_ns() { return read(CLOCK_MONOTONIC); }
std::uint64_t system_ns() { return read(CLOCK_REALTIME); }
std::uint64_t thread_cpu_ns() { return read(CLOCK_THREAD_CPUTIME_ID); }

}  // namespace robot
