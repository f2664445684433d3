#include "robot/lab/clocks/belief_error.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot/core/json_library.h"

namespace robot::lab {
namespace {

/// A robot at the origin that looks along y, and a ball that rolls along y; the robot sees it 0.1 m too far.
struct Rolling {
  TruthRecord truth;
  OwnPath own{.name = "14/2", .by = "its number", .path = {}, .poses = {}};
  RobotRecord robot;

  explicit Rolling(double speed, double ahead = 0) {
    for (double at = 0; at < 20; at += 1 / 30.0) {
      const double far = 1 + speed * at;
      truth.ball.push_back({.at = at, .x = 0, .y = far});
      own.path.push_back({.at = at, .x = 0, .y = 0});
      own.poses.poses.push_back({.at = at + ahead, .x = 0, .y = 0, .heading = std::acos(0.0)});
      robot.balls.push_back({.at = at + ahead, .x = far + 0.1, .y = 0});
    }
  }
};

TEST(BeliefErrors, AreKnownForAPlantedError) {
  const Rolling rolling(0.1);
  const BeliefErrors errors = belief_errors(rolling.truth, rolling.own, rolling.robot, {});
  EXPECT_GT(errors.all.place.samples, 580u);
  for (const ErrorFigures& figures : {errors.all.place, errors.all.distance}) {
    EXPECT_NEAR(figures.mean, 0.1, 1e-6);
    EXPECT_NEAR(figures.median, 0.1, 1e-6);
    EXPECT_NEAR(figures.p95, 0.1, 1e-6);
  }
  ASSERT_EQ(errors.bins.size(), 2u) << "without empty bins";
  EXPECT_EQ(errors.bins[0].from, 1);
  EXPECT_EQ(errors.bins[0].to, 2);
  EXPECT_EQ(errors.bins[0].place.samples + errors.bins[1].place.samples, errors.all.place.samples);
}

TEST(BeliefErrors, TheOffsetIsAppliedWithItsDrift) {
  const Rolling late(0.1, 3);
  EXPECT_NEAR(belief_errors(late.truth, late.own, late.robot, {}).all.distance.mean, 0.2, 0.01);
  EXPECT_NEAR(belief_errors(late.truth, late.own, late.robot, {.offset = 3}).all.distance.mean, 0.1, 1e-6);
  const DataOffset drifting{.offset = 2, .deviation = 0, .middle = 0, .drift = 0.1, .drift_deviation = 1e-9};
  EXPECT_NEAR(belief_errors(late.truth, late.own, late.robot, drifting).all.distance.mean, 0.13, 0.005)
      << "on average the offset is 2 s + 0.1 * 13 s, 0.3 s too much";
}

TEST(BeliefErrors, ImagesWithATooFastBallAreLeftOutAndCounted) {
  const Rolling fast(1.5);
  const DataOffset unsure{.offset = 0, .deviation = 0.015};
  const BeliefErrors errors = belief_errors(fast.truth, fast.own, fast.robot, unsure);
  EXPECT_EQ(errors.all.place.samples, 0u) << "1.5 m/s * 15 ms exceed the truth's 2 cm";
  EXPECT_GT(errors.too_fast, 580u);
  EXPECT_EQ(belief_errors(fast.truth, fast.own, fast.robot, {.offset = 0, .deviation = 0.01}).too_fast, 0u);
}

TEST(BeliefErrors, ImagesWithoutATruthAreLeftOutAndCounted) {
  Rolling rolling(0.1);
  std::erase_if(rolling.truth.ball, [](const PlaceAt& place) { return place.at > 5 && place.at < 10; });
  const BeliefErrors errors = belief_errors(rolling.truth, rolling.own, rolling.robot, {});
  EXPECT_NEAR(static_cast<double>(errors.without_truth), 150, 10);
  EXPECT_EQ(belief_errors({}, rolling.own, rolling.robot, {}).without_truth, rolling.robot.balls.size());
}

TEST(BeliefErrors, WithoutPosesOnlyDistancesAreKnown) {
  Rolling rolling(0.1);
  rolling.own.poses = {};
  const BeliefErrors errors = belief_errors(rolling.truth, rolling.own, rolling.robot, {});
  EXPECT_EQ(errors.all.place.samples, 0u);
  EXPECT_GT(errors.all.distance.samples, 580u);
}

TEST(BeliefErrors, AreATableAndJson) {
  const Rolling rolling(0.1);
  const BeliefErrors errors = belief_errors(rolling.truth, rolling.own, rolling.robot, {});
  EXPECT_NE(to_text(errors).find("\n1.0-2.0 m "), std::string::npos) << to_text(errors);
  const auto json = to_json(errors);
  EXPECT_EQ(json["bins"].size(), 2u);
  EXPECT_NEAR(json["all"]["place"]["mean"].get<double>(), 0.1, 1e-6);
  EXPECT_FALSE(json["all"].contains("to")) << "JSON has no infinity";
}

TEST(FiguresOf, KnownErrors) {
  std::vector<double> errors;
  for (int i = 100; i >= 0; --i) errors.push_back(i);
  const ErrorFigures figures = figures_of(errors);
  EXPECT_EQ(figures.samples, 101u);
  EXPECT_EQ(figures.mean, 50);
  EXPECT_EQ(figures.median, 50);
  EXPECT_EQ(figures.p95, 95);
  EXPECT_EQ(figures_of({}).samples, 0u);
  EXPECT_EQ(figures_of({1, 2}).median, 1.5);
}

}  // namespace
}  // namespace robot::lab
