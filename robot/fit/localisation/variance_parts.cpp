#include "robot/fit/localisation/variance_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/fit/math/least_squares.h"

namespace robot::fit {
namespace {

constexpr double kShareOfOutliers = 0.01, kOutlierWidth = 6;  // share of outliers, and their deviation in normal ones
// share of the squares of normal errors that their weights keep, with one and with two degrees of freedom
constexpr double kKeptOfOne = 0.98496, kKeptOfTwo = 0.99327;
constexpr double kLeastVariance = 1e-10;
constexpr double kSlowest = 0.3;  // of a factor in a round
constexpr int kFirstRounds = 40, kLaterRounds = 8;
constexpr std::size_t kVarianceSamples = 200;

/// The weighted normal equations of a round of scoring.
struct VarianceScoring {
  std::vector<Vector> matrix;
  Vector right;
};

VarianceScoring variance_scoring_of(const std::vector<SquaredError>& errors, const std::vector<std::size_t>& chosen,
                                    std::size_t parts, const VarianceParts& now, bool robust) {
  VarianceScoring scoring{std::vector<Vector>(parts, Vector(parts)), Vector(parts)};
  for (const std::size_t i : chosen) {
    const SquaredError& error = errors[i];
    const double variance = now.variance_of(error);
    const double squares = robust ? error.squares / (error.freedom < 1.5 ? kKeptOfOne : kKeptOfTwo) : error.squares;
    const double weight = (robust ? weight_of(error, variance) : 1) / (variance * variance);
    for (std::size_t a = 0; a < parts; ++a) {
      scoring.right[a] += weight * error.amounts[a] * (squares - error.freedom * error.known);
      for (std::size_t b = 0; b < parts; ++b)
        scoring.matrix[a][b] += weight * error.freedom * error.amounts[a] * error.amounts[b];
    }
  }
  return scoring;
}

/// Solves the equations of the parts in `free`. The others are 0.
std::optional<Vector> variance_solution_of(const VarianceScoring& scoring, const std::vector<std::size_t>& free) {
  std::vector<Vector> matrix;
  Vector right;
  for (const std::size_t a : free) {
    Vector row;
    for (const std::size_t b : free) row.push_back(scoring.matrix[a][b]);
    matrix.push_back(std::move(row));
    right.push_back(scoring.right[a]);
  }
  return solve(std::move(matrix), std::move(right));
}

/// Returns the factors of the next round. A part whose factor would be negative gets 0.
std::array<double, kMostParts> next_factors(const VarianceScoring& scoring, std::size_t parts) {
  std::vector<std::size_t> free;
  for (std::size_t a = 0; a < parts; ++a)
    if (scoring.matrix[a][a] > 0) free.push_back(a);
  std::array<double, kMostParts> factors{};
  while (!free.empty()) {
    const auto solved = variance_solution_of(scoring, free);
    const std::size_t worst =
        solved ? static_cast<std::size_t>(std::ranges::min_element(*solved) - solved->begin()) : free.size() - 1;
    if (solved && (*solved)[worst] >= 0) {
      for (std::size_t k = 0; k < free.size(); ++k) factors[free[k]] = (*solved)[k];
      break;
    }
    free.erase(free.begin() + static_cast<std::ptrdiff_t>(worst));
  }
  return factors;
}

void add_deviations(const std::vector<SquaredError>& errors, const std::vector<std::size_t>& chosen, std::size_t parts,
                    VarianceParts& fit) {
  const VarianceScoring scoring = variance_scoring_of(errors, chosen, parts, fit, false);
  fit.deviations.fill(INFINITY);
  for (std::size_t a = 0; a < parts; ++a) {
    Vector unit(parts);
    unit[a] = 1;
    if (const auto column = solve(scoring.matrix, unit); column && (*column)[a] > 0)
      fit.deviations[a] = std::sqrt(2 * (*column)[a]);
  }
}

std::vector<std::size_t> finite_errors(const std::vector<SquaredError>& errors) {
  std::vector<std::size_t> finite;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const SquaredError& error = errors[i];
    double sum = error.squares + error.freedom + error.known;
    for (const double amount : error.amounts) sum += amount;
    if (std::isfinite(sum) && error.squares >= 0 && error.freedom > 0) finite.push_back(i);
  }
  return finite;
}

/// Returns a start that outliers do not spoil: each part alone explains the median.
VarianceParts variance_start_of(const std::vector<SquaredError>& errors, const std::vector<std::size_t>& chosen,
                                std::size_t parts) {
  VarianceParts start;
  for (std::size_t a = 0; a < parts; ++a) {
    std::vector<double> ratios;
    for (const std::size_t i : chosen)
      if (errors[i].amounts[a] > 0) ratios.push_back(errors[i].squares / errors[i].freedom / errors[i].amounts[a]);
    if (ratios.empty()) continue;
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::ranges::nth_element(ratios, middle);
    start.factors[a] = 2 * *middle / static_cast<double>(parts);
  }
  return start;
}

/// Returns the interval of a root, for half an interval of the factor. The upper half is that of the logarithm if the factor is
/// clearly not 0, because a factor that is found too small has too small a deviation, too.
RootInterval root_interval(double factor, double half) {
  constexpr double kClear = 0.7;  // of the factor
  const double high = half < kClear * factor ? factor * std::exp(half / factor) : factor + half;
  return {.value = std::sqrt(factor), .low = std::sqrt(std::max(0., factor - half)), .high = std::sqrt(high)};
}

void improve_variances(const std::vector<SquaredError>& errors, const std::vector<std::size_t>& chosen,
                       std::size_t parts, int rounds, VarianceParts& fit) {
  for (int round = 0; round < rounds; ++round) {
    const auto factors = next_factors(variance_scoring_of(errors, chosen, parts, fit, true), parts);
    // a factor falls slowly: at 0 at once, the errors of its part alone would be outliers for ever
    for (std::size_t a = 0; a < parts; ++a) fit.factors[a] = std::max(factors[a], kSlowest * fit.factors[a]);
  }
}

}  // namespace

double VarianceParts::variance_of(const SquaredError& error) const {
  double variance = error.known;
  for (std::size_t i = 0; i < kMostParts; ++i) variance += factors[i] * error.amounts[i];
  return std::max(variance, kLeastVariance);
}

double weight_of(const SquaredError& error, double variance) {
  const double z = error.squares / variance;
  // the ratio of the densities of an outlier and of a normal error
  const double ratio = kShareOfOutliers / (1 - kShareOfOutliers) * std::pow(kOutlierWidth, -error.freedom) *
                       std::exp(std::min(500., z / 2 * (1 - 1 / (kOutlierWidth * kOutlierWidth))));
  return 1 / (1 + ratio);
}

VarianceParts fit_variances(const std::vector<SquaredError>& errors, std::size_t parts) {
  const std::vector<std::size_t> chosen = finite_errors(errors);
  VarianceParts fit = variance_start_of(errors, chosen, parts);
  improve_variances(errors, chosen, parts, kFirstRounds, fit);
  add_deviations(errors, chosen, parts, fit);
  return fit;
}

VarianceParts refit_variances(const std::vector<SquaredError>& errors, const std::vector<std::size_t>& chosen,
                              std::size_t parts, const VarianceParts& near) {
  VarianceParts fit = near;
  improve_variances(errors, chosen, parts, kLaterRounds, fit);
  return fit;
}

std::vector<RootInterval> root_intervals(const std::vector<SquaredError>& errors, const std::vector<Group>& groups,
                                         std::size_t parts, const VarianceParts& fitted) {
  const Vector around =
      deviations_of(resampled(groups, kVarianceSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
        const VarianceParts again = refit_variances(errors, chosen, parts, fitted);
        return {again.factors.begin(), again.factors.end()};
      }));
  std::vector<RootInterval> intervals;
  for (std::size_t a = 0; a < parts; ++a) {
    // resampled factors that stay at 0 would deviate too little
    const double half = two_sided(groups.size() - 1) * std::max(around[a], fitted.deviations[a]);
    intervals.push_back(root_interval(fitted.factors[a], half));
  }
  return intervals;
}

RootInterval relative_interval(const std::vector<SquaredError>& errors, const VarianceParts& fitted) {
  constexpr double kMostRelative = 1;  // of a root: the logarithm of its error
  const double factor = fitted.factors[0], value = std::sqrt(factor);
  if (factor == 0) return {.value = 0, .low = 0, .high = std::sqrt(2 * fitted.deviations[0])};
  const std::vector<Group> groups = single_groups(errors.size());
  const double around =
      deviations_of(resampled(groups, kVarianceSamples, [&](const std::vector<std::size_t>& chosen) -> Vector {
        return {std::log(std::max(refit_variances(errors, chosen, 1, fitted).factors[0], 1e-3 * factor)) / 2};
      }))[0];
  const double own = fitted.deviations[0] / factor / 2;
  const double half = std::min(kMostRelative, two_sided(groups.size() - 1) * std::max(around, own));
  return {.value = value, .low = value * std::exp(-half), .high = value * std::exp(half)};
}

}  // namespace robot::fit
