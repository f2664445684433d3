#include "robot/fit/localisation/odometry_fit.h"

#include <algorithm>
#include <cmath>

namespace robot::fit {
namespace {

constexpr int kOdometryRounds = 4;           // of variances and scales in turn
constexpr double kMostBias = 0.5;            // as in sim/perception/model.h
constexpr double kBiasChiSquare = 3.841459;  // 95 %, one degree of freedom

/// The sums of a weighted regression through the origin.
struct ScaleSums {
  double products = 0, squares = 0;

  void add(double weight, double product, double square) {
    products += weight * product;
    squares += weight * square;
  }

  OdometryScale scale() const {
    if (!(squares > 0)) return {};
    return {.value = 1 + products / squares, .deviation = 1 / std::sqrt(squares)};
  }
};

/// Returns the scales of walking. The true displacement has errors too: their variance is taken off both sums.
std::vector<OdometryScale> walking_scales(const std::vector<DriftWindow>& windows, const OdometryFit& fit,
                                          std::size_t recordings) {
  const std::vector<SquaredError> errors = place_errors(windows, fit.walking);
  std::vector<ScaleSums> sums(recordings);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const DriftWindow& window = windows[i];
    if (window.way == 0 || !std::isfinite(errors[i].squares)) continue;
    const double variance = fit.place.variance_of(errors[i]), noise = 2 * fit.place.factors[1];
    sums[window.recording].add(weight_of(errors[i], variance) / variance,
                               window.true_x * window.error_x + window.true_y * window.error_y + noise,
                               window.true_x * window.true_x + window.true_y * window.true_y - noise);
  }
  std::vector<OdometryScale> scales;
  for (const ScaleSums& one : sums) scales.push_back(one.scale());
  return scales;
}

std::vector<OdometryScale> turning_scales(const std::vector<DriftWindow>& windows, const OdometryFit& fit,
                                          std::size_t recordings) {
  const std::vector<SquaredError> errors = heading_errors(windows, fit.turning);
  std::vector<ScaleSums> sums(recordings);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const DriftWindow& window = windows[i];
    if (window.turned == 0 || !std::isfinite(errors[i].squares)) continue;
    const double variance = fit.heading.variance_of(errors[i]), noise = fit.heading.factors[2];
    sums[window.recording].add(weight_of(errors[i], variance) / variance, window.true_turn * window.error_turn + noise,
                               window.true_turn * window.true_turn - noise);
  }
  std::vector<OdometryScale> scales;
  for (const ScaleSums& one : sums) scales.push_back(one.scale());
  return scales;
}

std::vector<OdometryScale> known_scales_of(const OdometryFit& fit) {
  std::vector<OdometryScale> known;
  for (const auto* scales : {&fit.walking, &fit.turning})
    for (const OdometryScale& scale : *scales)
      if (scale.is_known()) known.push_back(scale);
  return known;
}

/// Returns twice the negative logarithm of the likelihood of a bias.
double bias_cost_of(const std::vector<OdometryScale>& scales, double bias) {
  double cost = 0;
  for (const OdometryScale& scale : scales) {
    const double variance = bias * bias + scale.deviation * scale.deviation;
    cost += std::log(variance) + std::pow(scale.value - 1, 2) / variance;
  }
  return cost;
}

/// Returns the place between an acceptable bias and one that is not, where the cost is `most`.
double bias_edge_of(const std::vector<OdometryScale>& scales, double good, double bad, double most) {
  for (int i = 0; i < 50; ++i) {
    const double middle = (good + bad) / 2;
    (bias_cost_of(scales, middle) <= most ? good : bad) = middle;
  }
  return good;
}

}  // namespace

double OdometryModel::place_variance(const DriftWindow& window) const {
  return translation_noise * translation_noise * window.grown_way + place_error * place_error;
}

double OdometryModel::heading_variance(const DriftWindow& window) const {
  return rotation_noise * rotation_noise * window.grown_turned +
         rotation_per_metre * rotation_per_metre * window.grown_way + heading_error * heading_error;
}

std::vector<SquaredError> place_errors(const std::vector<DriftWindow>& windows,
                                       const std::vector<OdometryScale>& walking) {
  std::vector<SquaredError> errors;
  errors.reserve(windows.size());
  for (const DriftWindow& window : windows) {
    const double scale = walking[window.recording].value - 1;
    const double x = window.error_x - scale * window.true_x, y = window.error_y - scale * window.true_y;
    errors.push_back({.squares = x * x + y * y, .freedom = 2, .amounts = {window.grown_way, 1, 0}});
  }
  return errors;
}

std::vector<SquaredError> heading_errors(const std::vector<DriftWindow>& windows,
                                         const std::vector<OdometryScale>& turning) {
  std::vector<SquaredError> errors;
  errors.reserve(windows.size());
  for (const DriftWindow& window : windows) {
    const double error = window.error_turn - (turning[window.recording].value - 1) * window.true_turn;
    errors.push_back({.squares = error * error, .freedom = 1, .amounts = {window.grown_turned, window.grown_way, 1}});
  }
  return errors;
}

std::size_t known_scales(const OdometryFit& fit) { return known_scales_of(fit).size(); }

RootInterval bias_interval(const OdometryFit& fit) {
  const std::vector<OdometryScale> scales = known_scales_of(fit);
  RootInterval bias;
  double least = bias_cost_of(scales, 0);
  constexpr int kSteps = 1000;
  for (int i = 1; i <= kSteps; ++i) {
    const double one = kMostBias * i / kSteps, cost = bias_cost_of(scales, one);
    if (cost < least) least = cost, bias.value = one;
  }
  // a little wider than for many scales
  const double most = least + kBiasChiSquare * (1 + 1 / static_cast<double>(scales.size()));
  bias.low = bias_cost_of(scales, 0) <= most ? 0 : bias_edge_of(scales, bias.value, 0, most);
  bias.high = bias_cost_of(scales, 2 * kMostBias) <= most ? 2 * kMostBias
                                                          : bias_edge_of(scales, bias.value, 2 * kMostBias, most);
  return bias;
}

OdometryFit fit_drift(const std::vector<DriftWindow>& windows, std::size_t recordings) {
  OdometryFit fit;
  fit.walking.resize(recordings);
  fit.turning.resize(recordings);
  for (int round = 0; round < kOdometryRounds; ++round) {
    fit.place = fit_variances(place_errors(windows, fit.walking), 2);
    fit.heading = fit_variances(heading_errors(windows, fit.turning), 3);
    fit.walking = walking_scales(windows, fit, recordings);
    fit.turning = turning_scales(windows, fit, recordings);
  }
  fit.model = {.bias = known_scales(fit) < kFewestScales ? NAN : bias_interval(fit).value,
               .translation_noise = std::sqrt(fit.place.factors[0]),
               .rotation_noise = std::sqrt(fit.heading.factors[0]),
               .rotation_per_metre = std::sqrt(fit.heading.factors[1]),
               .place_error = std::sqrt(fit.place.factors[1]),
               .heading_error = std::sqrt(fit.heading.factors[2])};
  return fit;
}

}  // namespace robot::fit
