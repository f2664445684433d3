#include "robot/fit/visibility/logistic.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robot/fit/math/least_squares.h"

namespace robot::fit {
namespace {

using Features = Logistic::Features;

constexpr std::size_t kCount = Logistic::kFeatures;
constexpr double kRidge = 0.01;  // 1 / 10², of weights in standard deviations
constexpr int kMostNewtonSteps = 50, kMostHalvings = 20;
constexpr double kLeastGain = 1e-8;  // of the logarithm of the likelihood

double sum_of(const Features& weights, const Features& features) {
  double sum = 0;
  for (std::size_t i = 0; i < kCount; ++i) sum += weights[i] * features[i];
  return sum;
}

/// Returns log(1 + exp(x)).
double soft_positive(double x) { return std::max(x, 0.) + std::log1p(std::exp(-std::abs(x))); }

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

/// The penalised likelihood of chosen sights.
class Likelihood {
 public:
  Likelihood(const std::vector<Sight>& sights, const std::vector<std::size_t>& chosen)
      : sights_(sights), chosen_(chosen) {
    Features sums{}, squares{};
    for (const std::size_t i : chosen) {
      const Features features = features_of(sights[i]);
      for (std::size_t k = 0; k < kCount; ++k) sums[k] += features[k], squares[k] += features[k] * features[k];
    }
    const auto count = static_cast<double>(std::max<std::size_t>(1, chosen.size()));
    // a feature that does not vary would have no curvature
    for (std::size_t k = 1; k < kCount; ++k)
      ridge_[k] = kRidge * std::max(1e-6, squares[k] / count - sums[k] / count * sums[k] / count);
    ridge_[0] = 1e-9;
  }

  double at(const Features& weights) const {
    double value = 0;
    for (const std::size_t i : chosen_) {
      const double x = sum_of(weights, features_of(sights_[i]));
      value += (sights_[i].seen ? x : 0) - soft_positive(x);
    }
    for (std::size_t k = 0; k < kCount; ++k) value -= ridge_[k] / 2 * weights[k] * weights[k];
    return value;
  }

  /// Returns the curvature, and writes the slope.
  std::vector<Vector> curvature(const Features& weights, Vector& slope) const {
    std::vector<Vector> curvature(kCount, Vector(kCount));
    slope.assign(kCount, 0);
    for (const std::size_t i : chosen_) {
      const Features features = features_of(sights_[i]);
      const double p = logistic(sum_of(weights, features)), rest = (sights_[i].seen ? 1 : 0) - p;
      for (std::size_t k = 0; k < kCount; ++k) {
        slope[k] += rest * features[k];
        for (std::size_t j = 0; j <= k; ++j) curvature[k][j] += p * (1 - p) * features[k] * features[j];
      }
    }
    for (std::size_t k = 0; k < kCount; ++k) {
      slope[k] -= ridge_[k] * weights[k];
      curvature[k][k] += ridge_[k];
      for (std::size_t j = 0; j < k; ++j) curvature[j][k] = curvature[k][j];
    }
    return curvature;
  }

 private:
  const std::vector<Sight>& sights_;
  const std::vector<std::size_t>& chosen_;
  Features ridge_{};
};

}  // namespace

double Logistic::probability(const Features& features) const { return logistic(sum_of(weights, features)); }

Features features_of(const Sight& sight) {
  return {1,
          sight.distance,
          sight.distance * sight.distance,
          sight.off_axis,
          sight.off_axis * sight.off_axis,
          sight.head_speed,
          sight.hidden ? 1. : 0.};
}

Logistic fit_logistic(const std::vector<Sight>& sights, const std::vector<std::size_t>& chosen) {
  const Likelihood likelihood(sights, chosen);
  Logistic fit;
  double value = likelihood.at(fit.weights);
  Vector slope;
  for (int step = 0; step < kMostNewtonSteps; ++step) {
    auto curvature = likelihood.curvature(fit.weights, slope);
    const auto way = solve(std::move(curvature), slope);
    if (!way) break;
    // half a step as long as a whole one leads downhill
    double share = 1, next_value = -INFINITY;
    Features next{};
    for (int halving = 0; halving < kMostHalvings && !(next_value > value); ++halving, share /= 2) {
      for (std::size_t k = 0; k < kCount; ++k) next[k] = fit.weights[k] + share * (*way)[k];
      next_value = likelihood.at(next);
    }
    if (!(next_value > value)) break;
    const bool enough = next_value - value < kLeastGain;
    fit.weights = next, value = next_value;
    if (enough) break;
  }
  return fit;
}

Features deviations_of(const Logistic& fit, const std::vector<Sight>& sights, const std::vector<Group>& passes) {
  const Group all = all_of(sights.size());
  Vector slope;
  const auto curvature = Likelihood(sights, all).curvature(fit.weights, slope);
  std::vector<Vector> scores;  // of each pass
  for (const Group& pass : passes) {
    scores.emplace_back(kCount);
    for (const std::size_t i : pass) {
      const Features features = features_of(sights[i]);
      const double rest = (sights[i].seen ? 1 : 0) - fit.probability(features);
      for (std::size_t k = 0; k < kCount; ++k) scores.back()[k] += rest * features[k];
    }
  }
  const auto count = static_cast<double>(passes.size());
  Features deviations{};
  for (std::size_t k = 0; k < kCount; ++k) {
    Vector unit(kCount);
    unit[k] = 1;
    const auto row = solve(curvature, std::move(unit));
    if (!row) continue;
    double squares = 0;
    for (const Vector& score : scores) {
      double along = 0;
      for (std::size_t j = 0; j < kCount; ++j) along += (*row)[j] * score[j];
      squares += along * along;
    }
    deviations[k] = std::sqrt(squares * count / std::max(1., count - 1));
  }
  return deviations;
}

}  // namespace robot::fit
