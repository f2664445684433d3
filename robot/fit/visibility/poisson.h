// The rate of rare events.
#pragma once

#include <cstddef>

namespace robot::fit {

struct MeanInterval {
  double low = 0, high = 0;
};

/// Returns the exact interval that covers 95 % for the mean of a Poisson distribution that gave `events` (Garwood 1936). Without
/// events it is 0 .. 3.69.
MeanInterval poisson_interval(std::size_t events);

}  // namespace robot::fit
