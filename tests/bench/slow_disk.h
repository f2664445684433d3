// A disk of limited speed, for machines where the real one cannot be slowed down: all of this program's
// file writes go through it.
#pragma once

#include <cstdint>

namespace bench {

struct SlowDisk {
  double bytes_per_second = 0;       // 0: the speed of the real disk
  std::uint64_t stall_ns = 0;        // duration of a stall
  std::uint64_t stall_every_ns = 0;  // time between the beginnings of two stalls; 0: never
};

/// Every writev() of this process to a regular file waits from now on as this disk would make it wait.
void use_slow_disk(const SlowDisk& disk);

}  // namespace bench
