// Counts what a test allocates. Linking it replaces the global operator new of the whole test program.
#pragma once

#include <cstddef>

namespace sim::test {

/// By all threads since the program started.
std::size_t allocations();

}  // namespace sim::test
