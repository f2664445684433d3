// Small problems of least squares: a few parameters, many residuals.
#pragma once

#include <functional>
#include <optional>
#include <vector>

namespace robot::lab {

using Vector = std::vector<double>;

/// Solves A x = b for a square matrix A, row by row. Returns nothing if A is singular.
std::optional<Vector> solve(std::vector<Vector> a, Vector b);

/// A problem with bounds of its parameters.
struct LeastSquares {
  Vector least, most;  // bounds
  /// Writes the residuals of `parameters`; their number is the same at each call.
  std::function<void(const Vector& parameters, Vector& residuals)> residuals;
};

struct Solution {
  Vector parameters;
  double cost =
      0;  // sum of sqrt(1 + r²) - 1 over all residuals r: half the square of a small one, linear in a large one
};

/// Minimises the cost from `start` (Levenberg and Marquardt). A result on a bound is possible. Deterministic.
Solution minimise(const LeastSquares& problem, Vector start);

}  // namespace robot::lab
