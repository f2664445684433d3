#include "robot/truth/synthetic/bodies.h"

#include <algorithm>
#include <cmath>

namespace robot::truth {
namespace {

using Eigen::Vector3f;

/// The frame of a body: +x forward, +y left, +z from its feet to its head.
struct BodyFrame {
  Vector3f origin;         // [m, field]
  Eigen::Matrix3f turned;  // field from body

  Vector3f operator()(double x, double y, double z) const {
    return origin + turned * Eigen::Vector3d(x, y, z).cast<float>();
  }
};

BodyFrame upright(double x, double y, double heading) {
  const auto cosine = static_cast<float>(std::cos(heading)), sine = static_cast<float>(std::sin(heading));
  BodyFrame frame;
  frame.origin = Eigen::Vector3d(x, y, 0).cast<float>();
  frame.turned << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
  return frame;
}

/// Returns the frame of a robot that lies with its back on the carpet; `heading` points from its feet to its head.
BodyFrame lying(double x, double y, double heading) {
  constexpr float kBack = 0.09F;  // [m] from the axis of its body
  BodyFrame frame = upright(x, y, heading);
  Eigen::Matrix3f back_down;
  back_down << 0, 0, 1, 0, -1, 0, 1, 0, 0;
  frame.turned *= back_down;
  frame.origin += Vector3f(0, 0, kBack) - frame.turned.col(2) * static_cast<float>(kRobotHeight / 2);
  return frame;
}

}  // namespace

void add(const SceneRobot& robot, std::vector<Capsule>& bodies) {
  const BodyFrame at = robot.fallen ? lying(robot.x, robot.y, robot.heading) : upright(robot.x, robot.y, robot.heading);
  const auto limb = [&](const Vector3f& from, const Vector3f& to, float radius) {
    bodies.push_back({from, to, radius, Material::robot});
  };
  for (const double side : {-1., 1.}) {
    const double foot = side * robot.stride / 2;
    limb(at(foot - 0.03, side * 0.055, 0.035), at(foot + 0.09, side * 0.055, 0.035), 0.035F);
    limb(at(foot, side * 0.055, 0.05), at(0, side * 0.055, 0.27), 0.045F);

    // the upper arm swings about the shoulder, the lower arm is bent by a right angle at most
    const double upper = robot.arms, lower = std::min(robot.arms + 0.8, 1.6);
    const Eigen::Vector3d shoulder(0, side * 0.115, 0.41);
    const Eigen::Vector3d elbow = shoulder + 0.105 * Eigen::Vector3d(std::sin(upper), side * 0.2, -std::cos(upper));
    const Eigen::Vector3d hand = elbow + 0.115 * Eigen::Vector3d(std::sin(lower), 0, -std::cos(lower));
    limb(at(shoulder.x(), shoulder.y(), shoulder.z()), at(elbow.x(), elbow.y(), elbow.z()), 0.036F);
    limb(at(elbow.x(), elbow.y(), elbow.z()), at(hand.x(), hand.y(), hand.z()), 0.03F);
  }
  limb(at(0, 0, 0.33), at(0, 0, 0.40), 0.088F);          // the trunk
  limb(at(0.01, 0, 0.513), at(0.01, 0, 0.513), 0.067F);  // the head
}

void add(const SceneBall& ball, std::vector<Capsule>& bodies) {
  const Vector3f centre = Eigen::Vector3d(ball.x, ball.y, ball.z).cast<float>();
  const Material material = ball.colour == BallColour::orange ? Material::orange : Material::patches;
  bodies.push_back({centre, centre, static_cast<float>(ball.radius), material});
}

void add(const ScenePerson& person, std::vector<Capsule>& bodies) {
  const BodyFrame at = upright(person.x, person.y, person.heading);
  const auto limb = [&](const Vector3f& from, const Vector3f& to, float radius) {
    bodies.push_back({from, to, radius, Material::person});
  };
  for (const double side : {-1., 1.}) {
    const double foot = side * person.stride / 2;
    limb(at(foot - 0.05, side * 0.1, 0.05), at(foot + 0.15, side * 0.1, 0.05), 0.05F);
    limb(at(foot, side * 0.1, 0.08), at(0, side * 0.1, 0.85), 0.075F);
    limb(at(0, side * 0.22, 1.38), at(-foot / 2, side * 0.26, 0.8), 0.045F);
  }
  limb(at(0, 0, 0.95), at(0, 0, 1.32), 0.16F);  // the trunk
  limb(at(0, 0, 1.63), at(0, 0, 1.63), 0.12F);  // the head
}

}  // namespace robot::truth
