// The whole body in the physics: messages of memory to the motion, its orders to the guardian, the guardian's answers to
// the servos, and the sensors back.
#include <gtest/gtest.h>

#include <cmath>

#include "robot/nao/guardian/guardian.h"
#include "robot/nao/motion/motion.h"
#include "tests/walk/lola_body.h"

namespace robot::nao {
namespace {

namespace pb = foresight;

constexpr std::uint64_t kCycle_ns = 12'000'000;

/// A robot that stands in the mode playing.
class BodyInPhysics : public ::testing::TestWithParam<walk::Servos> {
 protected:
  BodyInPhysics() : body_(walk::draw_robot(1, GetParam()), 1) {
    cycle();
    for (int clicks = 0; clicks < 3; ++clicks) click();
    for (int i = 0; i < 500 && guardian_.doing() != Doing::standing; ++i) cycle();
  }

  void click() {
    for (const bool pressed : {true, false}) {
      body_.sensors.touch[0] = pressed ? 1 : 0;
      run(0.1);
    }
  }

  void cycle() {
    now_ns_ += kCycle_ns;
    const Actuators& answer =
        guardian_.step({.now_ns = now_ns_, .sensors = &body_.sensors, .order = runtime_lives_ ? &order_ : nullptr});
    body_.obey(answer);
    if (runtime_lives_) order_ = motion_.next(report(answer), &command_, 0, nullptr);
  }

  void run(double seconds) {
    for (double time = 0; time < seconds; time += 0.012) cycle();
  }

  Report report(const Actuators& answer) const {
    Report report;
    report.mode = guardian_.mode();
    report.doing = guardian_.doing();
    report.has_sensors = true;
    report.capture_ns = now_ns_;
    report.sensors = body_.sensors;
    report.commanded = answer.position;
    report.commanded_stiffness = answer.stiffness;
    return report;
  }

  pb::MotionStatus status() {
    pb::MotionStatus status;
    motion_.fill_status(report({.position = body_.sensors.position, .stiffness = {}, .lights = {}}), status);
    return status;
  }

  bool upright() const { return body_.upright(); }
  walk::Truth truth() const { return body_.truth(); }

  LolaBody body_;
  Guardian guardian_;
  Motion motion_;
  Order order_;
  pb::MotionCommand command_;
  bool runtime_lives_ = true;
  std::uint64_t now_ns_ = 1'000'000'000;
};

TEST_P(BodyInPhysics, WalksTurnsAndStands) {
  ASSERT_EQ(guardian_.mode(), Mode::playing);
  ASSERT_EQ(guardian_.doing(), Doing::standing);
  const walk::Truth start = truth();
  command_.mutable_walk_speed()->set_x(0.15f);
  run(8);
  ASSERT_TRUE(upright());
  EXPECT_TRUE(status().walking());
  const walk::Truth there = truth();
  EXPECT_TRUE(motion_.has_odometry());
  pb::Odometry odometry;
  motion_.fill_odometry(odometry);
  const double ahead = (there.x - start.x) * std::cos(start.heading) + (there.y - start.y) * std::sin(start.heading);
  EXPECT_NEAR(odometry.x(), ahead, 0.15 * ahead);
  EXPECT_NEAR(odometry.heading(), std::remainder(there.heading - start.heading, 6.2831853), 0.2);
  EXPECT_GT(std::hypot(there.x - start.x, there.y - start.y), 0.6);

  command_.mutable_walk_speed()->set_x(0);
  command_.mutable_walk_speed()->set_turn_rate(0.5f);
  run(4);
  ASSERT_TRUE(upright());
  EXPECT_GT(std::remainder(truth().heading - there.heading, 6.2831853), 1);

  command_.set_posture(pb::MotionCommand::POSTURE_STAND);
  run(2);
  EXPECT_TRUE(upright());
  EXPECT_FALSE(status().walking());
  EXPECT_TRUE(status().standing());
}

TEST_P(BodyInPhysics, AHungRuntimeEndsInAStandThenASquat) {
  command_.mutable_walk_speed()->set_x(0.15f);
  run(5);
  ASSERT_TRUE(status().walking());
  runtime_lives_ = false;
  run(2);
  EXPECT_TRUE(upright());
  EXPECT_EQ(guardian_.doing(), Doing::holding);
  EXPECT_NEAR(body_.sensors.position[l_knee_pitch], stand_pose().position[l_knee_pitch], 0.1);
  run(1.5);
  EXPECT_EQ(guardian_.doing(), Doing::sitting_down);
}

TEST_P(BodyInPhysics, ThreeFingersOnTheHeadSoftenAWalkingRobotWithin100ms) {
  command_.mutable_walk_speed()->set_x(0.15f);
  run(5);
  ASSERT_TRUE(status().walking());
  for (const std::size_t head : {1, 2, 3}) body_.sensors.touch[head] = 1;
  run(0.1);
  EXPECT_EQ(body_.sensors.stiffness, PerJoint<float>{});
  EXPECT_FALSE(status().walking());
}

TEST_P(BodyInPhysics, AStandingRobotStepsAfterAPush) {
  command_.mutable_walk_speed()->set_x(0.05f);
  run(2);
  command_.set_posture(pb::MotionCommand::POSTURE_STAND);
  run(2);
  ASSERT_TRUE(status().standing());
  body_.push(1.8, 3.1416);
  bool stepped = false;
  for (int i = 0; i < 200; ++i) {
    cycle();
    stepped |= status().walking();
  }
  EXPECT_TRUE(stepped);
  EXPECT_TRUE(upright());
  EXPECT_TRUE(status().standing());
}

TEST_P(BodyInPhysics, WalksToAPlace) {
  const walk::Truth start = truth();
  const double x = start.x + 0.6 * std::cos(start.heading), y = start.y + 0.6 * std::sin(start.heading);
  for (int i = 0; i < 1200 && upright(); ++i) {
    const walk::Truth now = truth();
    const double ahead = (x - now.x) * std::cos(now.heading) + (y - now.y) * std::sin(now.heading);
    const double left = (y - now.y) * std::cos(now.heading) - (x - now.x) * std::sin(now.heading);
    pb::WalkTo& to = *command_.mutable_walk_to();
    to.set_x(static_cast<float>(ahead)), to.set_y(static_cast<float>(left));
    to.set_heading(static_cast<float>(std::remainder(start.heading - now.heading, 6.2831853)));
    to.set_gain(1);
    cycle();
  }
  ASSERT_TRUE(upright());
  EXPECT_LT(std::hypot(truth().x - x, truth().y - y), 0.06);
  EXPECT_FALSE(status().walking());
}

INSTANTIATE_TEST_SUITE_P(BothClasses, BodyInPhysics, ::testing::Values(walk::Servos::stiff, walk::Servos::soft),
                         [](const auto& tested) { return tested.param == walk::Servos::stiff ? "Stiff" : "Soft"; });

}  // namespace
}  // namespace robot::nao
