// The simulator's radio as distributions, and their parameters from observations. Pure.
#pragma once

#include <cstddef>
#include <vector>

namespace robot::fit {

/// Delays of this many means are cut off (sim/perception/radio.cpp).
inline constexpr double kLongestDelayInMeans = 5;

/// Returns the mean of an exponential delay with the parameter `mean` [s], cut at five of it and rounded to the nearest
/// multiple of `step` [s]; 0: not rounded.
double mean_delay(double mean, double step);

/// A parameter with the interval that covers 95 %.
struct Bounded {
  double value = 0, low = 0, high = 0;
};

/// One group of observations that share their luck, such as the receivers of one packet.
struct Shared {
  double sum = 0;         // of the observations
  std::size_t count = 0;  // at least 1
};

/// Returns the parameter of the delay for observed delays [s], grouped by packet. Delays beyond five means count as five, so
/// single wrong ones hardly count. `clock` [s] is one standard deviation of the mean by errors of the clocks. At least two groups.
Bounded fit_delay(const std::vector<std::vector<double>>& delays, double step, double clock);

/// Returns a share of hits: Wilson's interval, for as many independent observations as the scatter between groups shows.
/// At least two groups.
Bounded fit_share(const std::vector<Shared>& groups);

/// Returns the score of an exponential delay for one observation: the area between both distributions (CRPS) [s].
double delay_score(double mean, double seconds);

}  // namespace robot::fit
