// Counts the allocations of a test. Linking it replaces the global operator new of the whole test program.
#pragma once

#include <cstddef>

namespace sim::test {

/// Returns the number of allocations of all threads since the program started.
std::size_t allocations();

}  // namespace sim::test
