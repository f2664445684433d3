// Intervals of counts and shares that cover 95 %.
#pragma once

#include <cstddef>

namespace robot::fit {

struct CountInterval {
  double low = 0, high = 0;
};

/// Returns the exact interval for the mean of a Poisson distribution that gave `events` (Garwood 1936). Without events it is
/// 0 .. 3.69.
CountInterval poisson_interval(std::size_t events);

struct MeanDuration {
  double value = 0, low = 0, high = 0;  // [s]
};

/// Returns the mean of exponential durations: `ended` of them ended in `total` [s], the others were cut off. `ended` >= 1.
MeanDuration mean_duration(std::size_t ended, double total);

/// Returns the exact interval for a probability that gave `hits` of `cases` (Clopper and Pearson 1934).
CountInterval exact_share(std::size_t hits, std::size_t cases);

/// Returns the interval of Wilson (1927) for a probability that gave the share `share` [0..1] of `cases` independent observations,
/// which need not be a whole number. `deviations` is half the width of an interval of normal errors, in standard deviations.
CountInterval wilson_interval(double share, double cases, double deviations);

}  // namespace robot::fit
