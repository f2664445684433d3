// The whole body in the physics: messages of memory to the motion, its orders to the guardian, the guardian's answers to
// the servos, and the sensors back.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/walk/robot_in_physics.h"

namespace robot::nao {
namespace {

namespace pb = foresight;

class BodyInPhysics : public ::testing::TestWithParam<walk::Servos> {
 protected:
  walk::Truth truth() const { return robot.body.truth(); }

  RobotInPhysics robot{GetParam(), 1};
  LolaBody& body = robot.body;
  pb::MotionCommand& command = robot.command;
};

TEST_P(BodyInPhysics, WalksTurnsAndStands) {
  ASSERT_EQ(robot.guardian.mode(), Mode::playing);
  ASSERT_EQ(robot.guardian.doing(), Doing::standing);
  const walk::Truth start = truth();
  command.mutable_walk_speed()->set_x(0.15f);
  robot.run(8);
  ASSERT_TRUE(body.upright());
  EXPECT_TRUE(robot.status().walking());
  const walk::Truth there = truth();
  EXPECT_TRUE(robot.motion.has_odometry());
  pb::Odometry odometry;
  robot.motion.fill_odometry(odometry);
  const double ahead = (there.x - start.x) * std::cos(start.heading) + (there.y - start.y) * std::sin(start.heading);
  EXPECT_NEAR(odometry.x(), ahead, 0.15 * ahead);
  EXPECT_NEAR(odometry.heading(), std::remainder(there.heading - start.heading, 6.2831853), 0.2);
  EXPECT_GT(std::hypot(there.x - start.x, there.y - start.y), 0.6);

  command.mutable_walk_speed()->set_x(0);
  command.mutable_walk_speed()->set_turn_rate(0.5f);
  robot.run(4);
  ASSERT_TRUE(body.upright());
  EXPECT_GT(std::remainder(truth().heading - there.heading, 6.2831853), 1);

  command.set_posture(pb::MotionCommand::POSTURE_STAND);
  robot.run(2);
  EXPECT_TRUE(body.upright());
  EXPECT_FALSE(robot.status().walking());
  EXPECT_TRUE(robot.status().standing());
}

TEST_P(BodyInPhysics, AHungRuntimeEndsInAStandThenASquat) {
  command.mutable_walk_speed()->set_x(0.15f);
  robot.run(5);
  ASSERT_TRUE(robot.status().walking());
  robot.runtime_lives = false;
  robot.run(2);
  EXPECT_TRUE(body.upright());
  EXPECT_EQ(robot.guardian.doing(), Doing::holding);
  EXPECT_NEAR(body.sensors.position[l_knee_pitch], stand_pose().position[l_knee_pitch], 0.1);
  robot.run(1.5);
  EXPECT_EQ(robot.guardian.doing(), Doing::sitting_down);
}

TEST_P(BodyInPhysics, ThreeFingersOnTheHeadSoftenAWalkingRobotWithin100ms) {
  command.mutable_walk_speed()->set_x(0.15f);
  robot.run(5);
  ASSERT_TRUE(robot.status().walking());
  for (const std::size_t head : {1, 2, 3}) body.sensors.touch[head] = 1;
  robot.run(0.1);
  EXPECT_EQ(body.sensors.stiffness, PerJoint<float>{});
  EXPECT_FALSE(robot.status().walking());
}

TEST_P(BodyInPhysics, AStandingRobotStepsAfterAPush) {
  command.mutable_walk_speed()->set_x(0.05f);
  robot.run(2);
  command.set_posture(pb::MotionCommand::POSTURE_STAND);
  robot.run(2);
  ASSERT_TRUE(robot.status().standing());
  body.push(1.8, 3.1416);
  bool stepped = false;
  for (int i = 0; i < 200; ++i) {
    robot.cycle();
    stepped |= robot.status().walking();
  }
  EXPECT_TRUE(stepped);
  EXPECT_TRUE(body.upright());
  EXPECT_TRUE(robot.status().standing());
}

TEST_P(BodyInPhysics, GetsUpAfterAFallAndWalksOn) {
  for (const double direction : {0.0, 3.1416}) {
    SCOPED_TRACE(direction);
    RobotInPhysics faller(GetParam(), 1, false, true);
    faller.command.mutable_walk_speed()->set_x(0.1f);
    faller.run(2);
    faller.body.push(8, direction);
    bool lay = false, got_up = false, walked = false;
    for (int i = 0; i < 5000 && !walked; ++i) {
      faller.cycle();
      const pb::MotionStatus now = faller.status();
      lay |= now.fall() == pb::MotionStatus::FALL_FALLEN;
      got_up |= now.fall() == pb::MotionStatus::FALL_GETTING_UP && now.running() == "get_up" && now.remaining() > 0;
      walked = got_up && now.fall() == pb::MotionStatus::FALL_UPRIGHT && now.walking();
    }
    EXPECT_TRUE(lay && got_up && walked);
    faller.run(2);
    EXPECT_TRUE(faller.body.upright());
  }
}

TEST_P(BodyInPhysics, StandsInTheEndAlthoughTheRuntimeHungWhileItGotUp) {
  for (const double when : {2.0, 4.5, 5.5, 6.5, 7.5}) {
    SCOPED_TRACE(when);
    RobotInPhysics faller(GetParam(), 1, false, true);
    faller.command.set_posture(pb::MotionCommand::POSTURE_STAND);
    faller.body.drop(draw_drop(Lying::on_back, 1));
    for (int i = 0; i < 500 && faller.guardian.doing() != Doing::getting_up; ++i) faller.cycle();
    ASSERT_EQ(faller.guardian.doing(), Doing::getting_up);
    faller.run(when);
    faller.runtime_lives = false;
    faller.run(0.15);
    EXPECT_NE(faller.guardian.doing(), Doing::getting_up);
    faller.runtime_lives = true;
    for (int i = 0; i < 4000 && !(faller.body.upright() && faller.status().standing()); ++i) faller.cycle();
    EXPECT_TRUE(faller.body.upright());
    EXPECT_EQ(faller.guardian.doing(), Doing::standing);
  }
}

TEST_P(BodyInPhysics, LiesUntilAnotherCommandIfItIsToldToRelax) {
  RobotInPhysics faller(GetParam(), 1, false, true);
  faller.body.push(8, 0);
  faller.command.set_posture(pb::MotionCommand::POSTURE_RELAX);
  faller.run(8);
  EXPECT_FALSE(faller.body.upright());
  EXPECT_EQ(faller.body.sensors.stiffness, PerJoint<float>{});
}

TEST_P(BodyInPhysics, WalksToAPlace) {
  const walk::Truth start = truth();
  const double x = start.x + 0.6 * std::cos(start.heading), y = start.y + 0.6 * std::sin(start.heading);
  for (int i = 0; i < 1200 && body.upright(); ++i) {
    const walk::Truth now = truth();
    const double ahead = (x - now.x) * std::cos(now.heading) + (y - now.y) * std::sin(now.heading);
    const double left = (y - now.y) * std::cos(now.heading) - (x - now.x) * std::sin(now.heading);
    pb::WalkTo& to = *command.mutable_walk_to();
    to.set_x(static_cast<float>(ahead)), to.set_y(static_cast<float>(left));
    to.set_heading(static_cast<float>(std::remainder(start.heading - now.heading, 6.2831853)));
    to.set_gain(1);
    robot.cycle();
  }
  ASSERT_TRUE(body.upright());
  EXPECT_LT(std::hypot(truth().x - x, truth().y - y), 0.06);
  EXPECT_FALSE(robot.status().walking());
}

INSTANTIATE_TEST_SUITE_P(BothClasses, BodyInPhysics, ::testing::Values(walk::Servos::stiff, walk::Servos::soft),
                         [](const auto& tested) { return tested.param == walk::Servos::stiff ? "Stiff" : "Soft"; });

}  // namespace
}  // namespace robot::nao
