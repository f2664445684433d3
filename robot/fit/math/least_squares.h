// Small problems of least squares: a few parameters, many residuals.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace robot::fit {

using Vector = std::vector<double>;

/// Solves A x = b for a square matrix A, row by row. Returns nothing if A is singular.
std::optional<Vector> solve(std::vector<Vector> a, Vector b);

/// The cost of a residual r: half its square if it is small. Residuals are in standard deviations, or near that.
enum class Loss {
  soft_absolute,  // sqrt(1 + r²) - 1: linear in a large one
  cauchy,         // c²/2 log(1 + (r/c)²), c = 2.385: large ones hardly count. 95 % efficient for normal errors
};

/// A problem with bounds of its parameters.
struct LeastSquares {
  Vector least, most;  // bounds
  /// Writes the residuals of `parameters`; their number is the same at each call.
  std::function<void(const Vector& parameters, Vector& residuals)> residuals;
  Loss loss = Loss::soft_absolute;
};

struct Solution {
  Vector parameters;
  double cost = 0;  // sum of the losses of all residuals
};

/// Returns one standard deviation of each parameter, for residuals in standard deviations, or nothing if the residuals do not
/// depend on all parameters.
std::optional<Vector> parameter_deviations(const LeastSquares& problem, const Vector& parameters);

/// Minimises the cost from `start` (Levenberg and Marquardt). A result on a bound is possible. Deterministic.
Solution minimise(const LeastSquares& problem, Vector start);

}  // namespace robot::fit
