// The motions of the whole body keep the robot on its feet.
#include "robot/nao/guardian/key_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "robot/nao/guardian/get_up.h"

namespace robot::nao {
namespace {

constexpr float kCycle = 0.012f;  // [s]

struct Named {
  const char* name;
  KeyFrames motion;
};
constexpr Lying kSides[] = {Lying::on_back, Lying::on_front, Lying::on_left, Lying::on_right};

bool contains(Range range, float value) { return value >= range.low && value <= range.high; }

const Named kAll[] = {{"stand_up", stand_up()}, {"stand", stand()}, {"sit", sit()}, {"tuck", tuck()}};

TEST(KeyFrames, AreWithinTheLimitsOfTheJoints) {
  std::vector<Named> all(std::begin(kAll), std::end(kAll));
  for (const Lying side : kSides) all.push_back({"get_up", get_up(side)});
  for (const Named& named : all)
    for (const KeyFrame& frame : named.motion) {
      EXPECT_GT(frame.seconds, 0) << named.name;
      EXPECT_GT(frame.stiffness, 0) << named.name;
      EXPECT_LE(frame.stiffness, 1) << named.name;
      for (std::size_t joint = 0; joint < kJoints; ++joint)
        EXPECT_EQ(frame.position[joint], clamp(frame.position[joint], limits_of(joint).range))
            << named.name << " " << limits_of(joint).name;
      const Range pitch = head_pitch_range(frame.position[head_yaw]);
      EXPECT_EQ(frame.position[head_pitch], clamp(frame.position[head_pitch], pitch)) << named.name;
    }
}

TEST(KeyFrames, AreTheSameLeftAndRight) {
  for (const Named& named : kAll)
    for (const KeyFrame& frame : named.motion) {
      const PerJoint<float>& p = frame.position;
      for (const auto& [left, right, sign] : {std::tuple{l_shoulder_pitch, r_shoulder_pitch, 1},
                                              {l_shoulder_roll, r_shoulder_roll, -1},
                                              {l_elbow_yaw, r_elbow_yaw, -1},
                                              {l_elbow_roll, r_elbow_roll, -1},
                                              {l_hip_roll, r_hip_roll, -1},
                                              {l_hip_pitch, r_hip_pitch, 1},
                                              {l_knee_pitch, r_knee_pitch, 1},
                                              {l_ankle_pitch, r_ankle_pitch, 1},
                                              {l_ankle_roll, r_ankle_roll, -1}})
        EXPECT_EQ(p[left], static_cast<float>(sign) * p[right]) << named.name << " " << limits_of(left).name;
      EXPECT_EQ(p[head_yaw], 0) << named.name;
    }
}

TEST(GetUp, FindsTheSideThatIsDown) {
  EXPECT_EQ(lying({0.1f, -1.5f}), Lying::on_back);
  EXPECT_EQ(lying({-0.1f, 1.5f}), Lying::on_front);
  EXPECT_EQ(lying({3.1f, -1.4f}), Lying::on_back) << "the roll says nothing then";
  EXPECT_EQ(lying({-2.5f, 1.4f}), Lying::on_front);
  EXPECT_EQ(lying({-1.5f, 0.2f}), Lying::on_left);
  EXPECT_EQ(lying({1.5f, -0.2f}), Lying::on_right);
}

TEST(GetUp, EndsInTheStandFromTheBack) { EXPECT_EQ(get_up(Lying::on_back).back().position, stand_pose().position); }

TEST(GetUp, RollsToTheRightAsToTheLeft) {
  const KeyFrames left = get_up(Lying::on_left), right = get_up(Lying::on_right);
  ASSERT_EQ(left.size(), right.size());
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_EQ(right[i].position, mirrored(left[i].position));
    EXPECT_EQ(right[i].seconds, left[i].seconds);
  }
}

TEST(GetUp, BreaksOffOnlyWhenTheRobotShouldSit) {
  for (const Lying side : kSides)
    for (const float lies : {-1.55f, 1.55f})
      EXPECT_TRUE(contains(get_up(side).front().pitch, lies)) << "it lies when it begins";
  for (const float lies : {-1.55f, 1.55f}) EXPECT_FALSE(contains(get_up(Lying::on_back).back().pitch, lies));
  EXPECT_TRUE(contains(get_up(Lying::on_back).back().pitch, 0));
}

TEST(KeyFrames, MirroredTwiceAreTheSame) {
  for (const Lying side : kSides)
    for (const KeyFrame& frame : get_up(side)) EXPECT_EQ(mirrored(mirrored(frame.position)), frame.position);
}

/// Returns the distance of the hips in front of the ankles [m], with flat feet.
float hips_before_ankles(const PerJoint<float>& p, float torso_pitch) {
  const float thigh = torso_pitch + p[l_hip_pitch], tibia = thigh + p[l_knee_pitch];
  return 0.1f * std::sin(thigh) + 0.1029f * std::sin(tibia);
}

TEST(KeyFrames, OfStandingAndSittingKeepFeetFlatAndWeightAboveThem) {
  // at all times: the poses between key frames are straight lines in the joints
  for (const Named& named : {kAll[1], kAll[2]}) {
    Player player;
    player.play(named.motion, named.name == std::string("sit") ? stand()[0].position : sit()[0].position);
    while (!player.finished()) {
      const PerJoint<float> p = player.next(kCycle).position;
      const float torso = -(p[l_hip_pitch] + p[l_knee_pitch] + p[l_ankle_pitch]);
      EXPECT_LT(std::abs(torso), 0.1f) << named.name << ": the torso stays upright";
      // the foot reaches from 45 mm behind the ankle to 115 mm in front of it; most of the weight is in the torso
      EXPECT_GT(hips_before_ankles(p, torso), -0.02f) << named.name;
      EXPECT_LT(hips_before_ankles(p, torso), 0.06f) << named.name;
    }
  }
}

TEST(KeyFrames, TakeLongerWhenAsked) {
  const auto seconds = [](float longer) {
    Player player;
    player.play(sit(), stand_pose().position, longer);
    EXPECT_NEAR(player.remaining(), longer * sit()[0].seconds, 1e-5);
    int cycles = 0;
    for (; !player.finished(); ++cycles) player.next(kCycle);
    return static_cast<float>(cycles) * kCycle;
  };
  EXPECT_NEAR(seconds(1), 1.8, 0.02);
  EXPECT_NEAR(seconds(1.5f), 2.7, 0.02);
}

TEST(KeyFrames, AskForNoMoreThanHalfTheSpeed) {
  for (const Named& named : {kAll[1], kAll[2]}) {
    Player player;
    PerJoint<float> last = named.name == std::string("sit") ? stand()[0].position : sit()[0].position;
    player.play(named.motion, last);
    while (!player.finished()) {
      const PerJoint<float> p = player.next(kCycle).position;
      for (std::size_t joint = 0; joint < kJoints; ++joint)
        EXPECT_LE(std::abs(p[joint] - last[joint]), limits_of(joint).speed / 2 * kCycle) << limits_of(joint).name;
      last = p;
    }
  }
}

TEST(KeyFrames, ArePlayedFromTheStartToTheEnd) {
  Player player;
  player.play(stand_up(), {});
  EXPECT_FLOAT_EQ(player.remaining(), 3);
  EXPECT_FALSE(player.needs_feet());
  EXPECT_NEAR(player.next(1e-6f).position[l_knee_pitch], 0, 1e-6) << "begins where the joints are";
  while (!player.needs_feet()) player.next(kCycle);
  EXPECT_NEAR(player.remaining(), 1.5f, 0.02f);
  EXPECT_EQ(player.next(0).position[l_knee_pitch], sit()[0].position[l_knee_pitch]);
  Pose pose;
  while (!player.finished()) pose = player.next(kCycle);
  EXPECT_EQ(pose.position, stand()[0].position);
  EXPECT_EQ(player.remaining(), 0);
  EXPECT_FALSE(player.needs_feet());
  EXPECT_EQ(player.next(1).position, stand()[0].position) << "and stays there";
}

}  // namespace
}  // namespace robot::nao
