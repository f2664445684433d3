// Variances that are sums of known quantities times unknown factors. Pure.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "robot/fit/math/resampling.h"

namespace robot::fit {

inline constexpr std::size_t kMostParts = 3;

/// The squared errors of one event. For each degree of freedom their expectation is the sum of `amounts` times the factors, plus
/// `known`.
struct SquaredError {
  double squares = 0;                        // sum over the degrees of freedom
  double freedom = 1;                        // number of independent errors in it
  std::array<double, kMostParts> amounts{};  // of the parts, >= 0
  double known = 0;                          // variance that is not fitted
};

/// Factors >= 0 of the parts.
struct VarianceParts {
  std::array<double, kMostParts> factors{};
  std::array<double, kMostParts> deviations{};  // one standard deviation of each factor, for normal errors

  double variance_of(const SquaredError& error) const;
};

/// Fits the first `parts` factors by the greatest likelihood of normal errors. Errors beyond four deviations hardly count.
/// A part that no event has gets the factor 0 with an infinite deviation. Errors that are not finite are left out.
VarianceParts fit_variances(const std::vector<SquaredError>& errors, std::size_t parts);

/// As above for some of the errors, which may repeat, from factors that are near already.
VarianceParts refit_variances(const std::vector<SquaredError>& errors, const std::vector<std::size_t>& chosen,
                              std::size_t parts, const VarianceParts& near);

/// Returns the weight [0..1] of an error whose normal variance is `variance`: its probability to be no outlier.
double weight_of(const SquaredError& error, double variance);

/// The interval that covers 95 %, of the root of a factor.
struct RootInterval {
  double value = 0, low = 0, high = 0;
};

/// Returns the intervals of the roots of the first `parts` factors. Whole groups of errors are resampled, at least two.
std::vector<RootInterval> root_intervals(const std::vector<SquaredError>& errors, const std::vector<Group>& groups,
                                         std::size_t parts, const VarianceParts& fitted);

/// Returns the interval of the root of the only factor by its relative error, as suits few errors.
RootInterval relative_interval(const std::vector<SquaredError>& errors, const VarianceParts& fitted);

}  // namespace robot::fit
