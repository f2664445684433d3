// How fast this processor's clock ticks just now, without asking it.
#pragma once

#include <cstdint>

namespace sim::app {

/// [ns] that the calling thread has computed: what others do on this machine meanwhile does not count.
std::uint64_t computed_ns();

/// [1/ns] cycles, by a loop of additions that wait for each other, one a cycle on every processor this runs on.
/// Takes about a millisecond; the best of a few tries, since others can only slow it down.
double cycles_per_ns();

}  // namespace sim::app
