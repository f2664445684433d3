#include "tests/walk/physics.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cmath>

#include "tests/walk/our_gait.h"

namespace robot::nao::walk {
namespace {

TEST(Physics, TheModelWeighsWhatANaoWeighs) {
  for (const bool about_origin : {false, true}) {
    const std::string xml = model_of({.about_origin = about_origin});
    double mass = 0;
    for (std::size_t at = xml.find("mass='"); at != std::string::npos; at = xml.find("mass='", at + 1))
      mass += std::stod(xml.substr(at + 6));
    EXPECT_NEAR(mass, 5.305, 0.005);  // the URDF of a V5
  }
}

TEST(Physics, ARollingBallComesToRestWhereTheCarpetsDecelerationLetsIt) {
  Physics physics(Scene{.ball = true});
  physics.reset(draw_robot(1, Servos::stiff), 1, stand(), Parameters{}.hip_height);
  physics.place_ball(0.3, 0.5, 0.6);
  const Truth start = physics.truth();
  for (int i = 0; i < std::lround(4 / Physics::kStep); ++i) physics.step(0, 0);
  const Truth end = physics.truth();
  EXPECT_NEAR(std::hypot(end.ball_x - start.ball_x, end.ball_y - start.ball_y), 0.6 * 0.6 / (2 * 0.3), 0.05);
  EXPECT_LT(end.ball_speed, 0.02);
}

TEST(Physics, AServoThatHasWarmedUpIsAsWeakAsASoftOne) {
  const auto sag = [](const DrawnRobot& robot) {
    Physics physics({});
    physics.reset(robot, 1, stand(), Parameters{}.hip_height);
    physics.command(stand());
    for (int i = 0; i < 1500; ++i) physics.step(0, 0);
    return std::abs(physics.sense().joints[left][knee_pitch] - stand()[left][knee_pitch]);
  };
  const DrawnRobot stiff{.gain = 60}, soft{.gain = kSoftGain, .torque = kSoftTorque};
  DrawnRobot warm = stiff;
  warm.warms = 1;
  EXPECT_NEAR(sag(warm), sag(soft), 0.05 * sag(soft));
  EXPECT_GT(sag(warm), 1.5 * sag(stiff));
}

TEST(Physics, DrawnRobotsDifferAndStayInTheirRanges) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const DrawnRobot stiff = draw_robot(seed, Servos::stiff), soft = draw_robot(seed, Servos::soft);
    EXPECT_GE(stiff.gain, 45);
    EXPECT_LE(stiff.gain, 90);
    EXPECT_GE(soft.gain, 18);
    EXPECT_LE(soft.gain, 25);
    EXPECT_NE(stiff.friction, draw_robot(seed + 1, Servos::stiff).friction);
    // one motor turns both
    EXPECT_EQ(stiff.offset[left][hip_yaw_pitch], stiff.offset[right][hip_yaw_pitch]);
  }
}

}  // namespace
}  // namespace robot::nao::walk
