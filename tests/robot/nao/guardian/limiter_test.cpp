// Joints stay within their limits for every target.
#include "robot/nao/guardian/limiter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace robot::nao {
namespace {

TEST(Limiter, NeverLetsAJointBeyondItsRangeOrItsSpeed) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> angle(-4, 4), share(-0.5f, 1.5f), seconds(0, 0.012f), speed(0.1f, 1);
  Limiter limiter;
  limiter.start({});
  Pose target;
  PerJoint<float> measured{};
  for (int i = 0; i < 50'000; ++i) {
    if (random() % 20 == 0)
      for (float& position : target.position) position = angle(random);
    if (random() % 20 == 0)
      for (float& stiffness : target.stiffness) stiffness = random() % 8 == 0 ? 0 : share(random);
    if (random() % 50 == 0) target.position[random() % kJoints] = std::numeric_limits<float>::quiet_NaN();
    if (random() % 50 == 0) target.stiffness[random() % kJoints] = std::numeric_limits<float>::infinity();
    for (float& position : measured) position = angle(random);
    const Pose before = limiter.pose();
    const float dt = seconds(random), part = speed(random);
    if (random() % 500 == 0)
      limiter.soften(measured);
    else
      limiter.next(target, measured, dt, part);
    const Pose& after = limiter.pose();
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      const JointLimits& limits = limits_of(joint);
      ASSERT_GE(after.position[joint], limits.range.low) << limits.name;
      ASSERT_LE(after.position[joint], limits.range.high) << limits.name;
      ASSERT_GE(after.stiffness[joint], 0) << limits.name;
      ASSERT_LE(after.stiffness[joint], 1) << limits.name;
      ASSERT_LE(after.stiffness[joint], before.stiffness[joint] + Limiter::kStiffnessRise * dt + 1e-6f) << limits.name;
      if (before.stiffness[joint] > 0 && after.stiffness[joint] > 0) {
        ASSERT_LE(std::abs(after.position[joint] - before.position[joint]), limits.speed * part * dt + 1e-6f)
            << limits.name;
      }
    }
    const Range pitch = head_pitch_range(after.position[head_yaw]);
    ASSERT_GE(after.position[head_pitch], pitch.low);
    ASSERT_LE(after.position[head_pitch], pitch.high);
  }
}

TEST(Limiter, ReachesEveryTargetWithinTheLimits) {
  Limiter limiter;
  limiter.start({});
  Pose target;
  target.stiffness.fill(0.8f);
  // the head at the shoulder and far down: the pitch stops at the limit of the shell
  target.position[head_yaw] = 1.5f;
  target.position[head_pitch] = 0.5f;
  target.position[l_knee_pitch] = 3;
  for (int i = 0; i < 200; ++i) limiter.next(target, {}, 0.012f, 1);
  EXPECT_FLOAT_EQ(limiter.pose().position[head_yaw], 1.5f);
  EXPECT_FLOAT_EQ(limiter.pose().position[head_pitch], head_pitch_range(1.5f).high);
  EXPECT_FLOAT_EQ(limiter.pose().position[l_knee_pitch], limits_of(l_knee_pitch).range.high);
  EXPECT_FLOAT_EQ(limiter.pose().stiffness[r_hand], 0.8f);
}

TEST(Limiter, CommandsASoftJointToItsMeasuredPosition) {
  Limiter limiter;
  limiter.start({});
  PerJoint<float> measured{};
  measured[l_knee_pitch] = 1.2f;
  Pose target;
  target.stiffness.fill(1);
  target.position[l_knee_pitch] = 0;
  EXPECT_FLOAT_EQ(limiter.soften(measured).position[l_knee_pitch], 1.2f);
  limiter.next(target, measured, 0.012f, 1);
  EXPECT_NEAR(limiter.pose().position[l_knee_pitch], 1.2f - 6.402f * 0.012f, 1e-5) << "one step, no jump";
  EXPECT_NEAR(limiter.pose().stiffness[l_knee_pitch], 0.024f, 1e-6);
}

}  // namespace
}  // namespace robot::nao
