// Two rates of falls from counts: while walking, and more while touching another robot.
#pragma once

#include <cstddef>
#include <vector>

#include "robot/fit/falling/falls_in.h"

namespace robot::fit {

/// A rate and the values that the falls do not contradict.
struct FallRate {
  double value = 0, low = 0, high = 0;  // [1/s], 95 %
};

struct FallRates {
  FallRate walking, touching;
  std::size_t falls = 0;
  double of_walking = 0;        // share of them that are due to walking
  std::size_t unexplained = 0;  // of them: the robot neither walked nor touched another one
  double contact = 1;     // share of the time in contact in which robots did touch; the rest is the error of the truth
  double dispersion = 1;  // variance of the falls of a robot over that of chance; at least 1
};

/// Fits both rates by the greatest likelihood of a Poisson process: rates add, as in sim/motion/fall.cpp. The intervals are
/// those of the profile. Where robots differ more than by chance, they are wider.
/// Robots that touch overlap by the error of the truth half of the time. The time in contact is reduced to twice that time.
/// Falls of robots that neither walked nor touched another one are shared like the others, so that their number is right.
/// A rate without time of risk has the interval 0 to infinity.
FallRates fit_fall_rates(const std::vector<FallRisk>& robots);

/// The duration of one attempt to get up, from times on the ground that last one or several.
struct GroundTime {
  double attempt = 0;    // [s] mean
  double deviation = 0;  // [s] of one attempt
  double failure = 0;    // [0..1] probability that an attempt fails and is repeated
};

/// Fits the times on the ground [s] that are `chosen`, at least one. The number of attempts is not observed.
GroundTime fit_ground_time(const std::vector<double>& times, const std::vector<std::size_t>& chosen);

/// Returns the density of a time on the ground [1/s].
double density_of(const GroundTime& model, double time);

}  // namespace robot::fit
