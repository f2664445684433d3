// The whole body in the physics: messages of memory to the motion, its orders to the guardian, the guardian's answers to
// the servos, and the sensors back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "robot/nao/guardian/guardian.h"
#include "robot/nao/motion/motion.h"
#include "tests/support/fake_body.h"
#include "tests/walk/physics.h"

namespace robot::nao {
namespace {

namespace pb = foresight;

constexpr Joint kLegs[2][walk::kLegJoints] = {
    {l_hip_yaw_pitch, l_hip_roll, l_hip_pitch, l_knee_pitch, l_ankle_pitch, l_ankle_roll},
    {l_hip_yaw_pitch, r_hip_roll, r_hip_pitch, r_knee_pitch, r_ankle_pitch, r_ankle_roll},
};

/// Copies the legs to or from positions in LoLA's order.
template <class Legs, class Positions, class Copy>
void for_each_leg_joint(Legs& legs, Positions& positions, Copy&& copy) {
  for (const walk::Side side : {walk::left, walk::right})
    for (std::size_t joint = 0; joint < walk::kLegJoints; ++joint)
      copy(legs[side][joint], positions[kLegs[side][joint]]);
}

/// A robot that stands in the mode playing. The arms and the head follow at once; the legs are in the physics.
class BodyInPhysics : public ::testing::TestWithParam<walk::Servos> {
 protected:
  BodyInPhysics() {
    walk::Legs legs{};
    PerJoint<float> stand = stand_pose().position;
    for_each_leg_joint(legs, stand, [](double& leg, float position) { leg = position; });
    physics_ = std::make_unique<walk::Physics>(walk::Scene{});
    physics_->reset(walk::draw_robot(1, GetParam()), 1, legs, kStandingHip);
    body_.sensors.position = stand;
    body_.sensors.stiffness.fill(0.9f);
    order_.posture = Order::Posture::stand;
    // a stiff robot holds still until the chest button allows more
    cycle();
    click();
    click();
    for (int i = 0; i < 200 && guardian_.doing() != Doing::standing; ++i) cycle();
  }

  void click() {
    for (const bool pressed : {true, false}) {
      body_.press_chest(pressed);
      run(0.1);
    }
  }

  void cycle() {
    sense();
    now_ns_ += tests::kCycle_ns;
    Cycle inputs{.now_ns = now_ns_, .sensors = &body_.sensors, .order = runtime_lives_ ? &order_ : nullptr};
    const Actuators& answer = guardian_.step(inputs);
    obey(answer);
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

  bool upright() const { return physics_->truth().upright > 0.5 && physics_->truth().height > 0.2; }

  static constexpr double kStandingHip = 0.2321;  // [m] of the guardian's stand, from its angles

  std::unique_ptr<walk::Physics> physics_;
  tests::FakeBody body_;
  Guardian guardian_;
  Motion motion_;
  Order order_;
  pb::MotionCommand command_;
  bool runtime_lives_ = true;
  std::uint64_t now_ns_ = 1'000'000'000;

 private:
  void sense() {
    const walk::Sensors from = physics_->sense();
    Sensors& to = body_.sensors;
    std::copy(from.rate.begin(), from.rate.end(), to.gyroscope.begin());
    to.angles = {static_cast<float>(from.roll), static_cast<float>(from.pitch)};
    for (std::size_t i = 0; i < to.fsr.size(); ++i) to.fsr[i] = static_cast<float>(from.load[i / 4][i % 4]);
    for_each_leg_joint(from.joints, to.position,
                       [](double leg, float& position) { position = static_cast<float>(leg); });
  }

  void obey(const Actuators& answer) {
    walk::Legs legs{};
    for_each_leg_joint(legs, answer.position, [](double& leg, float position) { leg = position; });
    const float stiffness = answer.stiffness[l_knee_pitch];
    physics_->command(legs, stiffness);
    for (int i = 0; i < 6; ++i) physics_->step(0, 0);
    body_.sensors.stiffness = answer.stiffness;
    for (std::size_t joint = 0; joint < kJoints; ++joint)
      if (joint < l_hip_yaw_pitch || joint > r_ankle_roll) body_.sensors.position[joint] = answer.position[joint];
  }
};

TEST_P(BodyInPhysics, WalksTurnsAndStands) {
  ASSERT_EQ(guardian_.mode(), Mode::playing);
  ASSERT_EQ(guardian_.doing(), Doing::standing);
  const walk::Truth start = physics_->truth();
  command_.mutable_walk_speed()->set_x(0.15f);
  run(8);
  ASSERT_TRUE(upright());
  EXPECT_TRUE(status().walking());
  const walk::Truth there = physics_->truth();
  EXPECT_GT(std::hypot(there.x - start.x, there.y - start.y), 0.6);

  command_.mutable_walk_speed()->set_x(0);
  command_.mutable_walk_speed()->set_turn_rate(0.5f);
  run(4);
  ASSERT_TRUE(upright());
  EXPECT_GT(std::remainder(physics_->truth().heading - there.heading, 6.2831853), 1);

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
  body_.hold_head(true);
  run(0.1);
  EXPECT_EQ(body_.sensors.stiffness, PerJoint<float>{});
  EXPECT_FALSE(status().walking());
}

TEST_P(BodyInPhysics, WalksToAPlace) {
  const walk::Truth start = physics_->truth();
  const double x = start.x + 0.6 * std::cos(start.heading), y = start.y + 0.6 * std::sin(start.heading);
  for (int i = 0; i < 1200 && upright(); ++i) {
    const walk::Truth now = physics_->truth();
    const double ahead = (x - now.x) * std::cos(now.heading) + (y - now.y) * std::sin(now.heading);
    const double left = (y - now.y) * std::cos(now.heading) - (x - now.x) * std::sin(now.heading);
    pb::WalkTo& to = *command_.mutable_walk_to();
    to.set_x(static_cast<float>(ahead)), to.set_y(static_cast<float>(left));
    to.set_heading(static_cast<float>(std::remainder(start.heading - now.heading, 6.2831853)));
    to.set_gain(1);
    cycle();
  }
  ASSERT_TRUE(upright());
  EXPECT_LT(std::hypot(physics_->truth().x - x, physics_->truth().y - y), 0.06);
  EXPECT_FALSE(status().walking());
}

INSTANTIATE_TEST_SUITE_P(BothClasses, BodyInPhysics, ::testing::Values(walk::Servos::stiff, walk::Servos::soft),
                         [](const auto& tested) { return tested.param == walk::Servos::stiff ? "Stiff" : "Soft"; });

}  // namespace
}  // namespace robot::nao
