#include "robot/nao/walk/legs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "robot/nao/model/dimensions.h"

namespace robot::nao::walk {
namespace {

constexpr double kThigh = Dimensions{}.thigh, kTibia = Dimensions{}.tibia, kFootHeight = Dimensions{}.foot_height;
constexpr double kShortestLeg = 0.08;  // [m] from hip to ankle
constexpr double kLongestLeg = kThigh + kTibia - 1e-4;
constexpr double kYawPerJoint =
    0.72;  // [rad/rad] about: half the difference of the feet's yaws, per angle of the joint
constexpr double kLeastJoint = -1.1, kMostJoint = 0.7;  // [rad] of hip_yaw_pitch, inside its range

/// A rotation about the axis of hip_yaw_pitch, which leans by 45° to the middle.
class HipTurn {
 public:
  HipTurn(double angle, Side side)
      : y_(std::numbers::sqrt2 / 2), z_(-sign_of(side) * y_), cos_(std::cos(angle)), sin_(std::sin(angle)) {}

  /// Returns the vector in the frame of the hip, turned into the torso.
  Point turned(Point v) const { return turned(v, sin_); }
  Point turned_back(Point v) const { return turned(v, -sin_); }

 private:
  Point turned(Point v, double sine) const {
    const double along = (y_ * v.y + z_ * v.z) * (1 - cos_);
    return {v.x * cos_ + (y_ * v.z - z_ * v.y) * sine, v.y * cos_ + z_ * v.x * sine + y_ * along,
            v.z * cos_ - y_ * v.x * sine + z_ * along};
  }

  double y_, z_, cos_, sin_;
};

double arc_cosine(double value) { return std::acos(std::clamp(value, -1.0, 1.0)); }

/// Returns the angle of a triangle between the sides `a` and `b`.
double angle_between(double a, double b, double opposite) {
  return arc_cosine((a * a + b * b - opposite * opposite) / (2 * a * b));
}

/// Solves one leg for a given angle of hip_yaw_pitch and the upward normal of the sole. Returns the yaw that the foot
/// gets.
double solve(double joint, Side side, const Point& sole, const Point& normal, Leg& leg) {
  const HipTurn hip(joint, side);
  const Point ankle = hip.turned_back(
      {sole.x + normal.x * kFootHeight, sole.y + normal.y * kFootHeight, sole.z + normal.z * kFootHeight});
  const Point up = hip.turned_back(normal);

  // hip roll points the plane of the leg at the ankle; in it, thigh and tibia are a triangle
  const double roll = std::atan2(ankle.y, -ankle.z), down = std::hypot(ankle.y, ankle.z);
  const double length = std::clamp(std::hypot(down, ankle.x), kShortestLeg, kLongestLeg);
  const double knee = std::numbers::pi - angle_between(kThigh, kTibia, length);
  const double pitch = -(std::atan2(ankle.x, down) + angle_between(kThigh, length, kTibia));

  // the ankle turns the sole to its normal
  const double cosine = std::cos(roll), sine = std::sin(roll);
  const double normal_y = cosine * up.y + sine * up.z, normal_z = -sine * up.y + cosine * up.z;
  const double whole = std::atan2(up.x, normal_z);
  leg = {joint, roll, pitch, knee, whole - pitch - knee, -std::asin(std::clamp(normal_y, -1.0, 1.0))};

  // the direction of the toes
  const double forward = std::cos(whole), upward = -std::sin(whole);
  const Point toes = hip.turned({forward, -sine * upward, cosine * upward});
  return std::atan2(toes.y, toes.x);
}

}  // namespace

Legs reach(const std::array<Sole, 2>& soles, double tilt, double guess) {
  Legs legs;
  const Point normal{-std::sin(tilt), 0, std::cos(tilt)};
  const double wanted = (soles[left].yaw - soles[right].yaw) / 2;
  const auto yaw_at = [&](double joint) {
    const double of_left = solve(joint, left, soles[left].position, normal, legs[left]);
    return (of_left - solve(joint, right, soles[right].position, normal, legs[right])) / 2;
  };

  // two secant steps: the yaw is nearly proportional to the joint
  const double first = yaw_at(guess);
  double joint = std::clamp(guess - (wanted - first) / kYawPerJoint, kLeastJoint, kMostJoint);
  const double second = yaw_at(joint);
  if (std::abs(second - wanted) > 1e-6 && std::abs(second - first) > 1e-9) {
    joint = std::clamp(joint + (wanted - second) * (joint - guess) / (second - first), kLeastJoint, kMostJoint);
    yaw_at(joint);
  }
  return legs;
}

Point sole_of(const Leg& leg, Side side) {
  const double upper = leg[hip_pitch], lower = upper + leg[knee_pitch], foot = lower + leg[ankle_pitch];
  const double cosine = std::cos(leg[hip_roll]), sine = std::sin(leg[hip_roll]);
  const double along = kFootHeight * std::cos(leg[ankle_roll]);
  const double x = -kThigh * std::sin(upper) - kTibia * std::sin(lower) - along * std::sin(foot);
  const double y = kFootHeight * std::sin(leg[ankle_roll]);
  const double z = -kThigh * std::cos(upper) - kTibia * std::cos(lower) - along * std::cos(foot);
  return HipTurn(leg[hip_yaw_pitch], side).turned({x, cosine * y - sine * z, sine * y + cosine * z});
}

}  // namespace robot::nao::walk
