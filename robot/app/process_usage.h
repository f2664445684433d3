// What this process takes from the machine.
#pragma once

#include <cstdint>

namespace robot::app {

struct ProcessUsage {
  std::uint64_t cpu_ns = 0;          // of all threads, since the start
  std::uint64_t resident_bytes = 0;  // 0 where the system does not tell
};

/// As it is now. Any thread.
ProcessUsage process_usage();

}  // namespace robot::app
