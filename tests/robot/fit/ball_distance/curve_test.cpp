#include "robot/fit/ball_distance/curve.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/planted_balls.h"

namespace robot::fit {
namespace {

using tests::planted_balls;

TEST(Curve, ThePinholeFindsTheCamera) {
  std::vector<BallSize> sizes;
  for (double distance = 0.2; distance < 4; distance += 0.02)
    sizes.push_back({.radius = 0.7 + 24.2 / std::hypot(distance, 0.41), .distance = distance, .deviation = 0.001});
  const Curve curve = fit_curve(CurveKind::pinhole, sizes, all_of(sizes.size()));
  EXPECT_NEAR(curve.parameters[0], 24.2, 0.01);
  EXPECT_NEAR(curve.parameters[1], 0.7, 0.01);
  EXPECT_NEAR(curve.parameters[2], 0.41, 0.001);
  for (const BallSize& size : sizes) EXPECT_NEAR(curve.distance(size.radius), size.distance, 0.002);
}

TEST(Curve, ABallBelowTheCameraHasTheDistanceZero) {
  const Curve curve{.kind = CurveKind::pinhole, .parameters = {24.2, 0.7, 0.41}};
  EXPECT_EQ(curve.distance(100), 0);
  EXPECT_GT(curve.distance(0.1), 1) << "a radius below the blur is far away, not an error";
}

TEST(Curve, ThePowerLawOfTheThesisIsFoundAgain) {
  std::vector<BallSize> sizes;
  for (double radius = 4; radius < 30; ++radius)
    sizes.push_back({.radius = radius, .distance = 21.66 * std::pow(radius, -1.28)});
  const Curve curve = fit_curve(CurveKind::power_law, sizes, all_of(sizes.size()));
  EXPECT_NEAR(curve.parameters[0], 21.66, 1e-6);
  EXPECT_NEAR(curve.parameters[1], -1.28, 1e-9);
  EXPECT_NEAR(curve.distance(10), 21.66 * std::pow(10, -1.28), 1e-9);
}

TEST(Curve, TheConstantIsTheMedian) {
  const std::vector<BallSize> sizes{{.distance = 1}, {.distance = 2}, {.distance = 9}};
  EXPECT_EQ(fit_curve(CurveKind::constant, sizes, all_of(sizes.size())).distance(7), 2);
}

TEST(Curve, OccludedBallsHardlyMoveThePinhole) {
  const auto sizes = planted_balls({.occluded = 0.1, .passes = 100}, 3).sizes;
  const auto clean = planted_balls({.occluded = 0, .passes = 100}, 3).sizes;
  for (const double radius : {8., 15., 30.}) {
    const double moved = fit_curve(CurveKind::pinhole, sizes, all_of(sizes.size())).distance(radius);
    EXPECT_NEAR(moved, fit_curve(CurveKind::pinhole, clean, all_of(clean.size())).distance(radius), 0.06 * moved)
        << radius;
  }
}

TEST(Curve, OneObservationIsNoError) {
  const std::vector<BallSize> sizes{{.radius = 10, .distance = 1, .deviation = 0.02}};
  for (const CurveKind kind : {CurveKind::constant, CurveKind::power_law, CurveKind::pinhole})
    EXPECT_TRUE(std::isfinite(fit_curve(kind, sizes, {0}).distance(10))) << name_of(kind);
}

}  // namespace
}  // namespace robot::fit
