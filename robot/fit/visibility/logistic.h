// A logistic regression whose observations come in groups.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "robot/fit/math/resampling.h"
#include "robot/fit/visibility/sights.h"

namespace robot::fit {

/// Whether a ball in view is seen: 1 / (1 + exp(-x)) with x a sum of `weights` times the features.
struct Logistic {
  static constexpr std::size_t kFeatures = 7;
  /// constant, distance [m], its square, bearing from the optical axis [rad], its square, speed of the head [rad/s], hidden or not
  using Features = std::array<double, kFeatures>;

  Features weights{};

  double probability(const Features& features) const;
};

Logistic::Features features_of(const Sight& sight);

/// Fits the weights to the chosen sights by penalised maximum likelihood. The penalty is that of weights with a standard deviation
/// of 10, each for one standard deviation of its feature. It keeps a weight finite if a feature decides alone.
Logistic fit_logistic(const std::vector<Sight>& sights, const std::vector<std::size_t>& chosen);

/// Returns one standard deviation of each weight. Sights of one pass share their luck (Liang and Zeger 1986: the sandwich of the
/// curvature and the scores of whole passes).
Logistic::Features deviations_of(const Logistic& fit, const std::vector<Sight>& sights,
                                 const std::vector<Group>& passes);

}  // namespace robot::fit
