// A disk as slow as wished, for machines where no real one can be had: all of this program's file writes go through it.
#pragma once

#include <cstdint>

namespace bench {

struct SlowDisk {
  double bytes_per_second = 0;       // 0: as fast as the real one
  std::uint64_t stall_ns = 0;        // so long it takes nothing
  std::uint64_t stall_every_ns = 0;  // beginning each time this has passed; 0: never
};

/// Every writev() of this process to a regular file waits from now on as this disk would make it wait.
void use_slow_disk(const SlowDisk& disk);

}  // namespace bench
