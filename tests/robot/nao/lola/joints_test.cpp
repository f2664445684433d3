#include "robot/nao/lola/joints.h"

#include <gtest/gtest.h>

#include <numbers>
#include <string>

namespace robot::nao {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;

TEST(NaoJoints, AreMirroredLeftAndRight) {
  const auto number_of = [](const std::string& name) {
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      if (limits_of(joint).name == name) return joint;
    return kJoints;
  };
  for (std::size_t left = 0; left < kJoints; ++left) {
    const std::string name = limits_of(left).name;
    EXPECT_LT(limits_of(left).range.low, limits_of(left).range.high) << name;
    EXPECT_GT(limits_of(left).speed, 0) << name;
    if (!name.starts_with("l_") || left == l_hip_yaw_pitch) continue;
    const std::size_t right = number_of("r_" + name.substr(2));
    ASSERT_LT(right, kJoints) << name;
    EXPECT_EQ(limits_of(left).speed, limits_of(right).speed) << name;
    const bool turns_over = name.ends_with("roll") || name.ends_with("yaw");
    const Range range = limits_of(right).range;
    // the legs of a real robot differ by up to 0.6 degrees
    EXPECT_NEAR(limits_of(left).range.low, turns_over ? -range.high : range.low, 0.7f * kDegree) << name;
    EXPECT_NEAR(limits_of(left).range.high, turns_over ? -range.low : range.high, 0.7f * kDegree) << name;
  }
}

TEST(NaoJoints, TheHeadPitchesLessWhereTheShouldersAre) {
  EXPECT_NEAR(head_pitch_range(0).low, -38.5f * kDegree, 1e-5);
  EXPECT_NEAR(head_pitch_range(0).high, 29.5f * kDegree, 1e-5);
  EXPECT_NEAR(head_pitch_range(87.49f * kDegree).low, -18.91f * kDegree, 1e-5);
  EXPECT_NEAR(head_pitch_range(87.49f * kDegree).high, 11.46f * kDegree, 1e-5);
  // half way between two rows
  EXPECT_NEAR(head_pitch_range((27.85f + 43.32f) / 2 * kDegree).low, (-38.5f - 31.4f) / 2 * kDegree, 1e-5);
  EXPECT_NEAR(head_pitch_range(10).high, 18.91f * kDegree, 1e-5);
  for (float yaw = 0; yaw < 2.1f; yaw += 0.01f) {
    EXPECT_EQ(head_pitch_range(yaw).low, head_pitch_range(-yaw).low);
    EXPECT_EQ(head_pitch_range(yaw).high, head_pitch_range(-yaw).high);
    EXPECT_LT(head_pitch_range(yaw).low, 0);
    EXPECT_GT(head_pitch_range(yaw).high, 0);
  }
}

TEST(NaoJoints, AreClampedToTheirRanges) {
  EXPECT_EQ(clamp(3, {-1, 2}), 2);
  EXPECT_EQ(clamp(-3, {-1, 2}), -1);
  EXPECT_EQ(clamp(0.5f, {-1, 2}), 0.5f);
}

}  // namespace
}  // namespace robot::nao
