#include "tests/walk/drawn_robot.h"

#include <algorithm>
#include <numbers>

#include "tests/walk/dice.h"

namespace robot::nao::walk {
DrawnRobot draw_robot(std::uint64_t seed, Servos servos, double wider) {
  Dice dice(seed * 2 + (servos == Servos::soft ? 1 : 0) + 0x9e3779b97f4a7c15);
  const auto range = [&](double low, double high) {
    const double middle = (low + high) / 2, half = wider * (high - low) / 2;
    return dice.between(std::max(middle - half, 0.0), middle + half);
  };
  DrawnRobot robot;
  robot.servos = servos;
  if (servos == Servos::soft) {
    robot.gain = range(18, 25), robot.damping = range(0.8, 1.2), robot.armature = range(0.03, 0.05);
    robot.torque = kSoftTorque;
  } else {
    robot.gain = range(45, 90), robot.damping = range(0.6, 1.4), robot.armature = range(0.008, 0.02);
    robot.torque = range(0.8, 1);
  }
  robot.play = range(0, 2) * std::numbers::pi / 180;
  robot.friction = range(0.5, 1);
  robot.softness = range(0.005, 0.03);
  robot.delay = range(0.01, 0.03);
  robot.about_origin = dice.between(0, 1) < 0.5;
  for (auto& leg : robot.offset)
    for (double& offset : leg) offset = wider * 0.02 * dice.normal();
  robot.offset[1][0] = robot.offset[0][0];  // one motor
  for (double& bias : robot.rate_bias) bias = wider * 0.01 * dice.normal();
  robot.angle_lag = range(0, 0.02);
  robot.roll_bias = wider * 0.01 * dice.normal(), robot.pitch_bias = wider * 0.01 * dice.normal();
  for (double& gain : robot.load_gain) gain = std::max(0.0, 1 + wider * 0.2 * dice.normal());
  const double dead = dice.between(0, 80);
  if (dead < 8) robot.load_gain[static_cast<std::size_t>(dead)] = 0;
  return robot;
}

}  // namespace robot::nao::walk
