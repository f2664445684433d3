#include "robot/truth/tracks/posture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace robot::truth {
namespace {

Posture after(Posture posture, double height, int images) {
  for (int i = 0; i < images; ++i) posture = judged(posture, height);
  return posture;
}

TEST(Posture, OfALowRobotIsFallen) {
  EXPECT_TRUE(after({}, 0.2, 1).fallen);
  EXPECT_FALSE(after({}, 0.57, 1).fallen);
  EXPECT_TRUE(after(after({}, 0.57, 10), 0.2, 10).fallen);
}

TEST(Posture, BetweenTheThresholdsStaysAsItWas) {
  EXPECT_TRUE(after(after({}, 0.2, 10), 0.38, 10).fallen);
  EXPECT_FALSE(after(after({}, 0.57, 10), 0.38, 10).fallen);
}

TEST(Posture, DoesNotChangeByOneWrongHeight) { EXPECT_FALSE(judged(after({}, 0.57, 10), 0.2).fallen); }

TEST(Posture, IgnoresAHeightThatWasNotMeasured) {
  EXPECT_EQ(judged({}, 0).height, 0);
  EXPECT_EQ(judged({}, std::numeric_limits<double>::quiet_NaN()).height, 0);
}

}  // namespace
}  // namespace robot::truth
