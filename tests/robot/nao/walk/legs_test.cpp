#include "robot/nao/walk/legs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "robot/nao/model/kinematics.h"
#include "robot/nao/motion/leg_joints.h"

namespace robot::nao::walk {
namespace {

/// Returns the legs as joints of LoLA, for the other kinematics.
PerJoint<float> joints_of(const Legs& legs) {
  PerJoint<float> joints{};
  put_legs(legs, joints);
  return joints;
}

/// Returns soles within reach of a walking robot.
std::array<Sole, 2> drawn_soles(std::mt19937& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const double turn = between(-0.4, 0.2);
  std::array<Sole, 2> soles;
  for (const Side side : {left, right})
    soles[side] = {{between(-0.06, 0.06), between(-0.03, 0.03), between(-0.23, -0.18)}, sign_of(side) * turn};
  return soles;
}

TEST(Legs, PutTheSolesWhereTheyShouldBeByAnotherKinematics) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto soles = drawn_soles(random);
    const Legs legs = reach(soles, 0, 0);
    const PerJoint<float> joints = joints_of(legs);
    for (const Side side : {left, right}) {
      const Transform sole = Kinematics().hip_from_sole(joints, side == left ? nao::Side::left : nao::Side::right);
      const Point& wanted = soles[side].position;
      EXPECT_NEAR(sole.translation().x(), wanted.x, 1e-5) << "case " << i;
      EXPECT_NEAR(sole.translation().y(), wanted.y + sign_of(side) * 0.05, 1e-5) << "case " << i;
      EXPECT_NEAR(sole.translation().z(), wanted.z, 1e-5) << "case " << i;
      // the sole is level
      EXPECT_NEAR(sole.linear()(2, 2), 1, 1e-6) << "case " << i;
    }
  }
}

TEST(Legs, EachFootGetsHalfOfTheDifferenceOfBothYaws) {
  std::mt19937 random(2);
  for (int i = 0; i < 300; ++i) {
    const auto soles = drawn_soles(random);
    // the guess is that of the last tick, so it is good
    const PerJoint<float> joints = joints_of(reach(soles, 0, reach(soles, 0, 0)[left][hip_yaw_pitch]));
    const auto yaw = [&](nao::Side side) {
      const Eigen::Matrix3d rotation = Kinematics().hip_from_sole(joints, side).linear();
      return std::atan2(rotation(1, 0), rotation(0, 0));
    };
    EXPECT_NEAR(yaw(nao::Side::left) - yaw(nao::Side::right), soles[left].yaw - soles[right].yaw, 1e-4) << "case " << i;
  }
}

TEST(Legs, ATiltLeansTheTorsoForwardOverLevelSoles) {
  const std::array<Sole, 2> soles{{{{0, 0, -0.21}, 0}, {{0, 0, -0.21}, 0}}};
  const PerJoint<float> joints = joints_of(reach(soles, 0.1, 0));
  for (const nao::Side side : {nao::Side::left, nao::Side::right})
    EXPECT_NEAR(Kinematics().lean_on(joints, side).pitch, 0.1, 1e-5);
}

TEST(Legs, SoleOfIsTheInverseOfReach) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    const auto soles = drawn_soles(random);
    const Legs legs = reach(soles, 0, 0);
    for (const Side side : {left, right}) {
      const Point found = sole_of(legs[side], side);
      EXPECT_NEAR(found.x, soles[side].position.x, 1e-9);
      EXPECT_NEAR(found.y, soles[side].position.y, 1e-9);
      EXPECT_NEAR(found.z, soles[side].position.z, 1e-9);
    }
  }
}

TEST(Legs, MirroredSolesGiveMirroredLegs) {
  std::mt19937 random(4);
  for (int i = 0; i < 300; ++i) {
    const auto soles = drawn_soles(random);
    std::array<Sole, 2> mirrored;
    for (const Side side : {left, right}) {
      const Sole& sole = soles[other(side)];
      mirrored[side] = {{sole.position.x, -sole.position.y, sole.position.z}, -sole.yaw};
    }
    const Legs legs = reach(soles, 0.05, 0), image = reach(mirrored, 0.05, 0);
    for (const Side side : {left, right})
      for (const LegJoint joint : {hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll}) {
        const double sign = joint == hip_roll || joint == ankle_roll ? -1 : 1;
        EXPECT_NEAR(image[side][joint], sign * legs[other(side)][joint], 1e-12) << "case " << i;
      }
  }
}

TEST(Legs, APlaceOutOfReachGivesTheNearestLengthOfTheLeg) {
  const std::array<Sole, 2> far{{{{0, 0, -0.5}, 0}, {{0, 0, -0.01}, 0}}};
  const Legs legs = reach(far, 0, 0);
  EXPECT_NEAR(legs[left][knee_pitch], 0, 0.07);  // straight
  EXPECT_GT(legs[right][knee_pitch], 2);         // bent
  for (const Side side : {left, right})
    for (const double angle : legs[side]) EXPECT_TRUE(std::isfinite(angle));
}

}  // namespace
}  // namespace robot::nao::walk
