#include "robot/truth/calibration/least_squares.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace robot::truth {
namespace {

constexpr int kMostTrials = 100;
constexpr double kEnough = 1e-10;  // share of the cost that a step must still gain
constexpr double kMostDamping = 1e12;

}  // namespace

Eigen::MatrixXd slopes_at(const Residuals& residuals, const Eigen::VectorXd& parameters) {
  constexpr double kBy = 1e-6;
  const Eigen::VectorXd here = residuals(parameters);
  Eigen::MatrixXd slopes(here.size(), parameters.size());
  Eigen::VectorXd moved = parameters;
  for (Eigen::Index i = 0; i < parameters.size(); ++i) {
    moved[i] += kBy;
    slopes.col(i) = (residuals(moved) - here) / kBy;
    moved[i] = parameters[i];
  }
  return slopes;
}

Eigen::VectorXd minimise(const Residuals& residuals, Eigen::VectorXd start) {
  Eigen::VectorXd best = std::move(start), here = residuals(best);
  Eigen::MatrixXd slopes = slopes_at(residuals, best);
  double damping = 1e-4;
  for (int trial = 0; trial < kMostTrials && damping < kMostDamping; ++trial) {
    // a damped step of Gauss and Newton
    Eigen::MatrixXd curvature = slopes.transpose() * slopes;
    curvature.diagonal() *= 1 + damping;
    const Eigen::VectorXd next = best - curvature.ldlt().solve(slopes.transpose() * here);
    const Eigen::VectorXd there = residuals(next);
    if (!(there.squaredNorm() < here.squaredNorm())) {
      damping *= 10;
      continue;
    }
    const bool enough = here.squaredNorm() - there.squaredNorm() < kEnough * here.squaredNorm();
    best = next;
    here = there;
    if (enough) break;
    damping = std::max(1e-12, damping / 10);
    slopes = slopes_at(residuals, best);
  }
  return best;
}

}  // namespace robot::truth
