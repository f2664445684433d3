// Rates and durations of rare events. Pure.
#pragma once

#include <cstddef>

namespace robot::fit {

/// An interval that covers 95 %.
struct CountInterval {
  double value = 0, low = 0, high = 0;
};

/// Returns the mean number of events after `count` of them were seen (Garwood 1936). Without any, `low` is 0 and `high` 3.69.
CountInterval mean_count(std::size_t count);

/// Returns the mean of exponential durations: `ended` of them ended in `total` [s], the others were cut off. `ended` >= 1.
CountInterval mean_duration(std::size_t ended, double total);

}  // namespace robot::fit
