// A robot that walks exactly as the filter of ground truth expects: its covariances must be honest for it.
#pragma once

#include <vector>

#include "robot/truth/tracks/estimate.h"
#include "tests/support/truth_game.h"

namespace test {

/// The walk of a robot, its sensors' offsets included, and the filter's estimates: 30 images a second, noise 2 cm.
struct Walk {
  std::vector<robot::truth::Estimate::Mean> truth;
  std::vector<robot::truth::Estimate> online;
  std::vector<robot::truth::Step> steps;  // to each of them
};

/// Returns a walk that sensors see by turns. Their poses have errors of these deviations [m].
Walk walk_of(const std::vector<double>& deviations, std::size_t images, Random& random);

/// Returns the smoothed estimates of the walk.
std::vector<robot::truth::Estimate> smoothed_walk(const Walk& walk);

/// Returns the normalised squared error of place and velocity: 4 in the mean, variance 8, if the covariance is honest.
double normalised_error(const robot::truth::Estimate& estimate, const robot::truth::Estimate::Mean& truth);

}  // namespace test
