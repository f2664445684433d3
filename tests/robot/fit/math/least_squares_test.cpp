#include "robot/fit/math/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

namespace robot::fit {
namespace {

TEST(LeastSquares, SolvesAnEquation) {
  const auto solved = solve({{0, 2, 1}, {1, 1, 0}, {3, 0, 1}}, {7, 3, 6});
  ASSERT_TRUE(solved);
  EXPECT_NEAR((*solved)[0], 1, 1e-12);
  EXPECT_NEAR((*solved)[1], 2, 1e-12);
  EXPECT_NEAR((*solved)[2], 3, 1e-12);
  EXPECT_FALSE(solve({{1, 2}, {2, 4}}, {1, 2}));
}

/// Points of the curve a * exp(b x).
LeastSquares curve(double outlier) {
  return {.least = {0, -3}, .most = {10, 3}, .residuals = [outlier](const Vector& parameters, Vector& residuals) {
            residuals.clear();
            for (int i = 0; i < 20; ++i) {
              const double x = 0.1 * i, y = 2 * std::exp(-0.7 * x) + (i == 5 ? outlier : 0);
              residuals.push_back(10 * (parameters[0] * std::exp(parameters[1] * x) - y));
            }
          }};
}

TEST(LeastSquares, FindsTheParametersOfACurve) {
  const Solution found = minimise(curve(0), {1, 1});
  EXPECT_NEAR(found.parameters[0], 2, 1e-5);
  EXPECT_NEAR(found.parameters[1], -0.7, 1e-5);
  EXPECT_NEAR(found.cost, 0, 1e-9);
}

TEST(LeastSquares, AnOutlierMovesThemLittle) {
  const Solution found = minimise(curve(5), {1, 1});
  EXPECT_NEAR(found.parameters[0], 2, 0.1);
  EXPECT_NEAR(found.parameters[1], -0.7, 0.1);
}

TEST(LeastSquares, TheLossOfCauchyForgetsALargeOutlier) {
  LeastSquares problem = curve(500);
  const Solution pulled = minimise(problem, {2, -0.7});
  problem.loss = Loss::cauchy;
  const Solution found = minimise(problem, {2, -0.7});
  EXPECT_NEAR(found.parameters[0], 2, 0.001);
  EXPECT_NEAR(found.parameters[1], -0.7, 0.001);
  EXPECT_GT(std::abs(pulled.parameters[0] - 2), 0.01) << "a linear loss has a pull that does not fall";
}

TEST(LeastSquares, DeviationsOfTheParametersAreThoseOfALine) {
  // y = a + b x at x = -1, 0, 1: variances 1/3 and 1/2
  const LeastSquares line{.least = {-9, -9}, .most = {9, 9}, .residuals = [](const Vector& p, Vector& residuals) {
                            residuals = {p[0] - p[1], p[0], p[0] + p[1]};
                          }};
  const auto deviations = parameter_deviations(line, {0, 0});
  ASSERT_TRUE(deviations);
  EXPECT_NEAR((*deviations)[0], std::sqrt(1 / 3.), 1e-6);
  EXPECT_NEAR((*deviations)[1], std::sqrt(1 / 2.), 1e-6);
  const LeastSquares untold{.least = {-9, -9}, .most = {9, 9}, .residuals = [](const Vector& p, Vector& residuals) {
                              residuals = {p[0], p[0]};
                            }};
  EXPECT_FALSE(parameter_deviations(untold, {0, 0}));
}

TEST(LeastSquares, StaysWithinTheBounds) {
  LeastSquares problem = curve(0);
  problem.least[1] = -0.5;
  const Solution found = minimise(problem, {1, 1});
  EXPECT_DOUBLE_EQ(found.parameters[1], -0.5);
}

}  // namespace
}  // namespace robot::fit
