#include "robot/truth/calibration/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::truth {
namespace {

TEST(LeastSquares, FindsTheValleyOfRosenbrock) {
  const Residuals residuals = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::Vector2d(1 - p[0], 10 * (p[1] - p[0] * p[0]));
  };
  const Eigen::VectorXd found = minimise(residuals, Eigen::Vector2d(-1.2, 1));
  EXPECT_NEAR(found[0], 1, 1e-6);
  EXPECT_NEAR(found[1], 1, 1e-6);
}

TEST(LeastSquares, GivesTheMeanOfContradictions) {
  const Residuals residuals = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::Vector3d(p[0] - 1, p[0] - 2, p[0] - 6);
  };
  EXPECT_NEAR(minimise(residuals, Eigen::VectorXd::Zero(1))[0], 3, 1e-6);
}

TEST(LeastSquares, HasTheDerivativesOfTheResiduals) {
  const Residuals residuals = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::Vector2d(3 * p[0], p[0] * p[1]);
  };
  Eigen::Matrix2d expected;
  expected << 3, 0, 5, 2;
  EXPECT_TRUE(slopes_at(residuals, Eigen::Vector2d(2, 5)).isApprox(expected, 1e-5));
}

TEST(LeastSquares, NeverGoesWhereResidualsAreNotFinite) {
  const Residuals residuals = [](const Eigen::VectorXd& p) -> Eigen::VectorXd {
    return Eigen::VectorXd::Constant(1, std::log(p[0]) + 8);
  };
  EXPECT_NEAR(minimise(residuals, Eigen::VectorXd::Constant(1, 1.))[0], std::exp(-8), 1e-6);
}

}  // namespace
}  // namespace robot::truth
