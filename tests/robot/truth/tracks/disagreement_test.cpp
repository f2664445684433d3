#include "robot/truth/tracks/disagreement.h"

#include <gtest/gtest.h>

#include "tests/robot/truth/tracks/images.h"
#include "tests/support/truth_game.h"

namespace robot::truth {
namespace {

/// Lets two sensors that are `apart` [m] from each other see a robot that walks, for `images` images.
Disagreement compared(double apart, double shared_deviation, int images) {
  test::Random random(31);
  Disagreement disagreement;
  const Eigen::Matrix2d shared = shared_deviation * shared_deviation * Eigen::Matrix2d::Identity();
  for (int i = 0; i < images; ++i)
    for (const std::size_t sensor : {0u, 2u}) {
      const double t = i / 30. + (sensor == 2 ? 0.015 : 0);
      const double x = 0.3 * t + (sensor == 2 ? apart : 0) + 0.02 * random.normal();
      disagreement.compare({sensor, seen_at(x, 0.02 * random.normal())}, shared, {0.3, 0}, at_seconds(t));
    }
  return disagreement;
}

TEST(Disagreement, OfSensorsBeyondTheirErrorsIsFound) {
  const auto found = compared(0.18, 0.02, 30).worst(at_seconds(1));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->first, 0u);
  EXPECT_EQ(found->second, 2u);
  EXPECT_NEAR(found->apart, 0.18, 0.02);
  EXPECT_NEAR(found->expected, 0.058, 0.003);
}

TEST(Disagreement, WithinTheErrorsOfThePosesIsNone) {
  EXPECT_FALSE(compared(0.14, 0.06, 30).worst(at_seconds(1)));
  EXPECT_FALSE(compared(0, 0.02, 30).worst(at_seconds(1)));
}

TEST(Disagreement, NeedsTenComparisonsAndFreshOnes) {
  EXPECT_FALSE(compared(0.3, 0.02, 5).worst(at_seconds(0.2)));
  EXPECT_TRUE(compared(0.3, 0.02, 30).worst(at_seconds(1.4)));
  EXPECT_FALSE(compared(0.3, 0.02, 30).worst(at_seconds(1.6)));
}

TEST(Disagreement, IsOneSentence) {
  EXPECT_EQ(sentence_of({0, 1, 0.14, 0.04}, "robot 3", {1.2, -0.4}),
            "sensors 1 and 2 place robot 3 at (1.20, -0.40) m 14 cm apart, expected 4 cm");
}

}  // namespace
}  // namespace robot::truth
