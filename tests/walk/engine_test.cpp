// The same laws hold in both engines.
#include "tests/walk/engine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/walk/our_gait.h"
#include "tests/walk/physics.h"
#include "tests/walk/trial.h"

namespace robot::nao::walk {
namespace {

constexpr double kHipHeight = Parameters{}.hip_height;
constexpr double kMass = 5.305;  // [kg]
constexpr DrawnRobot kRobot{.load_gain = {1, 1, 1, 1, 1, 1, 1, 1}};

class InEngine : public ::testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (GetParam() && !ode_engine({})) GTEST_SKIP() << "without libode-dev";
  }

  std::unique_ptr<Engine> engine() const {
    const Scene scene{.ode = GetParam()};
    return scene.ode ? ode_engine(scene) : mujoco_engine(scene);
  }
};

void wait(Engine& engine, double seconds) {
  for (int i = 0; i < std::lround(seconds / Engine::kStep); ++i) engine.step();
}
void wait(Physics& physics, double seconds) {
  for (int i = 0; i < std::lround(seconds / Physics::kStep); ++i) physics.step(0, 0);
}

TEST_P(InEngine, ARobotInTheAirFallsFreely) {
  const auto one = engine();
  Dice dice(1);
  one->reset(kRobot, dice, {}, 3);
  const double before = one->position()[2];
  wait(*one, 0.4);
  EXPECT_NEAR(before - one->position()[2], kGravity * 0.4 * 0.4 / 2, 0.01);
  EXPECT_NEAR(one->now(), 0.4, 1e-9);
  for (const double load : one->loads()) EXPECT_EQ(load, 0);
}

TEST_P(InEngine, AForceInTheAirAcceleratesTheWholeMass) {
  const auto one = engine();
  Dice dice(1);
  one->reset(kRobot, dice, {}, 50);
  one->push(-10, 20);
  wait(*one, 0.1);
  one->push(0, 0);
  // the torso turns and the limbs swing, so its own speed says less than that of the whole: look at the mean of one swing
  const auto from = one->position();
  wait(*one, 0.4);
  const auto to = one->position();
  EXPECT_NEAR((to[0] - from[0]) / 0.4, -10 * 0.1 / kMass, 0.12);
  EXPECT_NEAR((to[1] - from[1]) / 0.4, 20 * 0.1 / kMass, 0.2);
}

TEST_P(InEngine, TheTorsoTurnsAsItIsTold) {
  const auto one = engine();
  Dice dice(1);
  one->reset(kRobot, dice, {}, 1);
  const double half = std::numbers::pi / 8;
  one->turn(2, {std::cos(half), 0, std::sin(half), 0});  // pitched by 45°
  EXPECT_NEAR(one->position()[2], 2, 1e-9);
  EXPECT_NEAR(-one->rotation()[6], std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(one->rotation()[8], std::sqrt(0.5), 1e-9);
}

TEST_P(InEngine, EachMotorTurnsItsOwnJointTowardsItsTorque) {
  for (std::size_t motor = 0; motor < kLegMotors; ++motor) {
    const auto one = engine();
    Dice dice(1);
    one->reset(kRobot, dice, {}, 50);  // in the air
    PerMotor before{};
    for (std::size_t other = 0; other < kLegMotors; ++other) before[other] = one->joint(other).angle;
    one->drive(motor, 2);
    wait(*one, 0.02);
    const JointState driven = one->joint(motor);
    EXPECT_GT(driven.angle - before[motor], 1e-4) << motor;
    EXPECT_GT(driven.speed, 0) << motor;
    for (std::size_t other = 0; other < kLegMotors; ++other) {
      if (other == motor) continue;
      // one motor turns both hips
      const bool both = motor % kLegJoints == hip_yaw_pitch && other % kLegJoints == hip_yaw_pitch;
      const double moved = std::abs(one->joint(other).angle - before[other]) / (driven.angle - before[motor]);
      EXPECT_TRUE(both ? moved > 0.8 : moved < 0.8) << motor << " moves " << other << " by " << moved;
    }
  }
}

TEST_P(InEngine, AStandingRobotCarriesItsWeightOnBothFeet) {
  for (const bool about_origin : {false, true}) {
    Physics physics({.about_origin = about_origin, .ode = GetParam()});
    physics.reset(kRobot, 1, stand(), kHipHeight);
    physics.command(stand());
    wait(physics, 2);
    const Sensors sensors = physics.sense();
    EXPECT_NEAR(sensors.load_of(left) + sensors.load_of(right), kMass, 0.5);
    EXPECT_NEAR(sensors.load_of(left), sensors.load_of(right), 0.3);
    EXPECT_NEAR(sensors.roll, 0, 0.03);
    EXPECT_GT(physics.truth().upright, 0.99);
  }
}

TEST_P(InEngine, APushToOneSideLoadsThatFoot) {
  for (const double side : {1, -1}) {
    Physics physics({.ode = GetParam()});
    physics.reset(kRobot, 1, stand(), kHipHeight);
    physics.command(stand());
    wait(physics, 1);
    for (int i = 0; i < 200; ++i) physics.step(0, 5 * side);  // > 0 to the left
    const Sensors sensors = physics.sense();
    EXPECT_GT(side * (sensors.load_of(left) - sensors.load_of(right)), 1) << side;
  }
}

TEST_P(InEngine, ATargetTakesEffectAfterTheDelay) {
  Physics physics({.ode = GetParam()});
  Legs legs = stand();
  physics.reset(kRobot, 1, legs, kHipHeight);
  const double before = physics.sense().joints[left][knee_pitch];
  legs[left][knee_pitch] += 0.3;
  physics.command(legs);
  const auto moved_in = [&](double seconds) {
    wait(physics, seconds);
    return physics.sense().joints[left][knee_pitch] - before;
  };
  EXPECT_LT(std::abs(moved_in(0.018)), 0.02);
  EXPECT_GT(moved_in(0.15), 0.05);
}

TEST_P(InEngine, TheSameSeedGivesTheSameCourse) {
  Physics physics({.ode = GetParam()});
  const DrawnRobot robot = draw_robot(3, Servos::soft);
  const auto course = [&] {
    OurGait gait;
    return run(physics, gait, robot, 3, stand(), kHipHeight,
               {.duration = 3, .command = [](double) { return Command{.forward = 0.2}; }});
  };
  const Outcome first = course(), second = course();
  EXPECT_FALSE(first.fell);
  EXPECT_GT(first.forward, 0.05);
  EXPECT_EQ(first.forward, second.forward);
  EXPECT_EQ(first.left, second.left);
  EXPECT_EQ(first.path, second.path);
}

INSTANTIATE_TEST_SUITE_P(Both, InEngine, ::testing::Bool(),
                         [](const auto& engine) { return engine.param ? "ode" : "mujoco"; });

}  // namespace
}  // namespace robot::nao::walk
