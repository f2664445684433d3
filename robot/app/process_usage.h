// The processor time and the memory of this process.
#pragma once

#include <cstdint>

namespace robot::app {

/// The use of the machine by this process.
struct ProcessUsage {
  std::uint64_t cpu_ns = 0;          // of all threads, since the start
  std::uint64_t resident_bytes = 0;  // 0 if the system does not report it
};

/// Measures the current use. Called by any thread.
ProcessUsage process_usage();

}  // namespace robot::app
