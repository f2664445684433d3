#include "robot/fit/math/least_squares.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robot::fit {
namespace {

constexpr int kMostSteps = 100;
constexpr double kEnough = 1e-9;  // share of the cost that a step must still gain
constexpr double kMostDamping = 1e12;

// Holland and Welsch 1977, Robust regression using iteratively reweighted least-squares
constexpr double kCauchy = 2.385;

double cost_of(Loss loss, const Vector& residuals) {
  double cost = 0;
  for (const double residual : residuals) {
    const double square = residual * residual, far = kCauchy * kCauchy;
    cost += loss == Loss::cauchy ? far / 2 * std::log1p(square / far) : std::sqrt(1 + square) - 1;
  }
  return cost;
}

/// Returns the weight of a residual in the normal equations: the slope of its loss, divided by the residual.
double weight_of(Loss loss, double residual) {
  const double square = residual * residual;
  return loss == Loss::cauchy ? 1 / (1 + square / (kCauchy * kCauchy)) : 1 / std::sqrt(1 + square);
}

/// The normal equations of a step: the gradient and the curvature of the cost, with the weight of each residual.
struct Normal {
  std::vector<Vector> curvature;
  Vector gradient;
};

Normal normal_at(const LeastSquares& problem, const Vector& parameters, const Vector& residuals) {
  const std::size_t count = parameters.size();
  std::vector<Vector> slopes(count, Vector(residuals.size()));
  for (std::size_t i = 0; i < count; ++i) {
    Vector moved = parameters;
    const double by = 1e-6 * std::max(1., std::abs(moved[i]));
    moved[i] += moved[i] + by > problem.most[i] ? -by : by;
    problem.residuals(moved, slopes[i]);
    for (std::size_t k = 0; k < residuals.size(); ++k)
      slopes[i][k] = (slopes[i][k] - residuals[k]) / (moved[i] - parameters[i]);
  }
  Normal normal{.curvature = std::vector<Vector>(count, Vector(count)), .gradient = Vector(count)};
  for (std::size_t k = 0; k < residuals.size(); ++k) {
    const double weight = weight_of(problem.loss, residuals[k]);
    for (std::size_t i = 0; i < count; ++i) {
      normal.gradient[i] += weight * slopes[i][k] * residuals[k];
      for (std::size_t j = 0; j < count; ++j) normal.curvature[i][j] += weight * slopes[i][k] * slopes[j][k];
    }
  }
  return normal;
}

/// Returns the parameters after a damped step, within the bounds.
std::optional<Vector> stepped(const LeastSquares& problem, const Vector& parameters, const Normal& normal,
                              double damping) {
  std::vector<Vector> curvature = normal.curvature;
  for (std::size_t i = 0; i < parameters.size(); ++i) curvature[i][i] += damping * (curvature[i][i] + 1e-12);
  const auto step = solve(std::move(curvature), normal.gradient);
  if (!step) return std::nullopt;
  Vector next = parameters;
  for (std::size_t i = 0; i < next.size(); ++i)
    next[i] = std::clamp(next[i] - (*step)[i], problem.least[i], problem.most[i]);
  return next;
}

}  // namespace

std::optional<Vector> solve(std::vector<Vector> a, Vector b) {
  const std::size_t count = b.size();
  for (std::size_t column = 0; column < count; ++column) {
    std::size_t pivot = column;
    for (std::size_t row = column + 1; row < count; ++row)
      if (std::abs(a[row][column]) > std::abs(a[pivot][column])) pivot = row;
    if (!(std::abs(a[pivot][column]) > 1e-300)) return std::nullopt;
    std::swap(a[column], a[pivot]), std::swap(b[column], b[pivot]);
    for (std::size_t row = column + 1; row < count; ++row) {
      const double factor = a[row][column] / a[column][column];
      for (std::size_t i = column; i < count; ++i) a[row][i] -= factor * a[column][i];
      b[row] -= factor * b[column];
    }
  }
  for (std::size_t row = count; row-- > 0;) {
    for (std::size_t i = row + 1; i < count; ++i) b[row] -= a[row][i] * b[i];
    b[row] /= a[row][row];
  }
  return b;
}

std::optional<Vector> parameter_deviations(const LeastSquares& problem, const Vector& parameters) {
  Vector residuals;
  problem.residuals(parameters, residuals);
  const Normal normal = normal_at(problem, parameters, residuals);
  Vector deviations(parameters.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Vector unit(parameters.size());
    unit[i] = 1;
    const auto column = solve(normal.curvature, std::move(unit));
    if (!column || !((*column)[i] > 0)) return std::nullopt;
    deviations[i] = std::sqrt((*column)[i]);
  }
  return deviations;
}

Solution minimise(const LeastSquares& problem, Vector start) {
  Solution best{.parameters = std::move(start)};
  Vector residuals, trial;
  problem.residuals(best.parameters, residuals);
  trial.resize(residuals.size());
  best.cost = cost_of(problem.loss, residuals);
  double damping = 1e-3;
  Normal normal = normal_at(problem, best.parameters, residuals);
  for (int step = 0; step < kMostSteps && damping < kMostDamping; ++step) {
    const auto next = stepped(problem, best.parameters, normal, damping);
    if (next) problem.residuals(*next, trial);
    const double cost = next ? cost_of(problem.loss, trial) : best.cost;
    if (!(cost < best.cost)) {
      damping *= 5;
      continue;
    }
    const bool enough = best.cost - cost < kEnough * best.cost;
    best = {.parameters = *next, .cost = cost};
    std::swap(residuals, trial);
    if (enough) break;
    damping = std::max(1e-9, damping / 5);
    normal = normal_at(problem, best.parameters, residuals);
  }
  return best;
}

}  // namespace robot::fit
