#include "robot/fit/rolling/rolling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace robot::fit {
namespace {

/// A truth in which the ball is kicked every 8 s and rolls, 30 images a second.
class KickedBall {
 public:
  double deceleration = 0.3;  // [m/s²]
  double error = 0;           // [m] of each place, one standard deviation
  double turn = 0;            // [rad] of the way, 0.8 s after the kick

  lab::TruthRecord truth(int kicks) {
    lab::TruthRecord record;
    record.ball_deviation = 0.02;
    for (int kick = 0; kick < kicks; ++kick) {
      const double speed = 0.8 + 0.1 * (kick % 10), angle = 0.7 * kick;
      for (int i = 0; i < 240; ++i) add(record, kick * 8 + i / 30., speed, angle, i / 30.);
    }
    return record;
  }

 private:
  double way(double speed, double t) const {
    const double end = std::min(t, speed / deceleration);
    return speed * end - deceleration * end * end / 2;
  }

  void add(lab::TruthRecord& record, double at, double speed, double angle, double t) {
    const double straight = way(speed, std::min(t, 0.8)), after = way(speed, t) - straight;
    const double x = straight * std::cos(angle) + after * std::cos(angle + turn);
    const double y = straight * std::sin(angle) + after * std::sin(angle + turn);
    record.ball.push_back({.at = at, .x = x + error * normal_(random_), .y = y + error * normal_(random_)});
    record.sightings.push_back({.at = at, .seen = true});
  }

  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
};

Evidence evidence_of(lab::TruthRecord record) {
  Evidence evidence;
  evidence.games.push_back(std::make_shared<const TrueGame>(TrueGame{.name = "game", .record = std::move(record)}));
  return evidence;
}

TEST(RollsIn, OneRollForEachKickAndItsDeceleration) {
  const auto rolls = rolls_in(KickedBall().truth(10), 3);
  ASSERT_EQ(rolls.size(), 10u);
  for (std::size_t i = 0; i < rolls.size(); ++i) {
    EXPECT_EQ(rolls[i].recording, 3u);
    EXPECT_NEAR(rolls[i].deceleration, 0.3, 0.01) << i;
    EXPECT_LT(rolls[i].end_speed, rolls[i].speed);
    EXPECT_GE(rolls[i].end_speed, 0.2) << "it ends before the ball stops";
  }
}

TEST(RollsIn, ARollEndsAtARobot) {
  lab::TruthRecord truth = KickedBall().truth(1);
  const auto free = rolls_in(truth, 0);
  ASSERT_EQ(free.size(), 1u);
  lab::TrueRobotPath robot{.name = "14/2", .path = {}};
  for (const lab::PlaceAt& ball : truth.ball) robot.path.push_back({.at = ball.at, .x = 0.9, .y = 0.3});
  truth.robots.push_back(robot);
  const auto touched = rolls_in(truth, 0);
  ASSERT_EQ(touched.size(), 1u);
  EXPECT_LT(touched[0].duration, free[0].duration - 0.3);
}

TEST(RollsIn, ARollEndsAtAReboundOrAGap) {
  KickedBall ball;
  ball.turn = 0.9;
  for (const Roll& roll : rolls_in(ball.truth(10), 0)) EXPECT_NEAR(roll.deceleration, 0.3, 0.05);
  lab::TruthRecord gap = KickedBall().truth(1);
  std::erase_if(gap.ball, [](const lab::PlaceAt& place) { return place.at > 1 && place.at < 1.4; });
  const auto rolls = rolls_in(gap, 0);
  ASSERT_FALSE(rolls.empty());
  for (const Roll& roll : rolls) EXPECT_TRUE(roll.at + roll.duration <= 1.01 || roll.at >= 1.39);
}

TEST(RollsIn, ABallThatLiesOrNoBallIsNoRoll) {
  lab::TruthRecord still;
  for (int i = 0; i < 300; ++i) still.ball.push_back({.at = i / 30., .x = 1, .y = 1});
  EXPECT_TRUE(rolls_in(still, 0).empty());
  EXPECT_TRUE(rolls_in({}, 0).empty());
}

TEST(Rolling, TheIntervalCoversThePlantedDecelerationDespiteTheTruthsError) {
  KickedBall ball;
  ball.deceleration = 0.4, ball.error = 0.02;
  int covered = 0;
  for (int i = 0; i < 12; ++i) {
    const auto fit = fit_rolling(evidence_of(ball.truth(40)));
    ASSERT_TRUE(fit) << fit.error();
    covered += fit->deceleration.low <= 0.4 && fit->deceleration.high >= 0.4;
    EXPECT_LT(fit->deceleration.high - fit->deceleration.low, 0.1);
  }
  EXPECT_GE(covered, 10);
}

TEST(Rolling, TooFewRollsAreRefused) {
  EXPECT_EQ(fit_rolling(evidence_of(KickedBall().truth(3))).error(),
            "expected at least 8 free rolls of half a second, got 3");
  EXPECT_FALSE(fit_rolling({}));
}

TEST(Rolling, SaysWhatItDoesNotKnow) {
  const auto fit = fit_rolling(evidence_of(KickedBall().truth(10)));
  ASSERT_TRUE(fit) << fit.error();
  EXPECT_NE(fit->kept.find("ball.stop_speed stays"), std::string::npos);
  EXPECT_EQ(table_of(*fit).rows.size(), 10u);
  EXPECT_NE(to_text(*fit).find("ball.deceleration"), std::string::npos);
}

}  // namespace
}  // namespace robot::fit
