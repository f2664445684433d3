// Problems of least squares with a few parameters near 0.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace robot::truth {

/// Returns the residuals of parameters. Their number is the same at each call.
using Residuals = std::function<Eigen::VectorXd(const Eigen::VectorXd& parameters)>;

/// Returns the derivatives of the residuals: a row for each residual, a column for each parameter.
Eigen::MatrixXd slopes_at(const Residuals& residuals, const Eigen::VectorXd& parameters);

/// Returns the parameters with the least sum of squares that a descent from `start` reaches (Levenberg and Marquardt).
/// Parameters with residuals that are not finite are never returned, unless `start` is among them. Deterministic.
Eigen::VectorXd minimise(const Residuals& residuals, Eigen::VectorXd start);

}  // namespace robot::truth
