// The uncertainty of a fitted parameter, by fits to resampled data.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "robot/fit/math/least_squares.h"

namespace robot::fit {

/// Standard deviations in the median of absolute normal errors.
inline constexpr double kOfMedian = 1.4826;

/// Returns one standard deviation of the median of `count` values whose median distance from it is `distance`. For normal errors the
/// median deviates 1.25 times as much as the mean.
double deviation_of_median(double distance, std::size_t count);

/// The observations of one pass, roll or kick, by their indices. Observations of one group share their luck, so only whole
/// groups are resampled.
using Group = std::vector<std::size_t>;

/// Returns the indices 0 .. count - 1: all observations.
Group all_of(std::size_t count);
/// Returns a group for each observation: none share their luck.
std::vector<Group> single_groups(std::size_t count);

/// Returns the parameters that fit the observations; some may be there several times.
using Estimate = std::function<Vector(const std::vector<std::size_t>& observations)>;

/// Returns the estimates of `count` samples, each of as many groups as there are, drawn with replacement. Deterministic.
std::vector<Vector> resampled(const std::vector<Group>& groups, std::size_t count, const Estimate& estimate);

/// Returns one standard deviation of each parameter over the estimates, at least two.
Vector deviations_of(const std::vector<Vector>& estimates);

/// Returns half the width of an interval that covers 95 %, in standard deviations that `freedom` + 1 groups tell: Student's
/// distribution (Abramowitz and Stegun 26.7.5). `freedom` >= 1.
double two_sided(std::size_t freedom);

}  // namespace robot::fit
