#include "robot/nao/model/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace robot::nao {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

Transform turn(double angle, const Vector3d& axis) { return Transform(AngleAxisd(angle, axis)); }
Transform about_x(double angle) { return turn(angle, Vector3d::UnitX()); }
Transform about_y(double angle) { return turn(angle, Vector3d::UnitY()); }
Transform about_z(double angle) { return turn(angle, Vector3d::UnitZ()); }
Transform shift(double x, double y, double z) { return Transform(Eigen::Translation3d(x, y, z)); }

/// The joints of one leg.
struct LegJoints {
  double hip_yaw_pitch, hip_roll, hip_pitch, knee_pitch, ankle_pitch, ankle_roll;
};

LegJoints leg_of(const PerJoint<float>& joints, Side side) {
  if (side == Side::left)
    return {joints[l_hip_yaw_pitch], joints[l_hip_roll],    joints[l_hip_pitch],
            joints[l_knee_pitch],    joints[l_ankle_pitch], joints[l_ankle_roll]};
  // one motor turns both legs
  return {joints[l_hip_yaw_pitch], joints[r_hip_roll],    joints[r_hip_pitch],
          joints[r_knee_pitch],    joints[r_ankle_pitch], joints[r_ankle_roll]};
}

/// Rotation from camera axes (right, down, forward) to robot axes (forward, left, up).
const Eigen::Matrix3d kForwardLeftUpFromRightDownForward =
    (Eigen::Matrix3d() << 0, 0, 1, -1, 0, 0, 0, -1, 0).finished();

}  // namespace

Transform Kinematics::hip_from_sole(const PerJoint<float>& joints, Side side) const {
  const LegJoints leg = leg_of(joints, side);
  const double left = side == Side::left ? 1 : -1;
  // the axis is half way between a yaw axis and a pitch axis
  const Vector3d axis = Vector3d(0, 1, -left).normalized();
  return shift(0, left * dimensions_.hip_half_width, 0) * turn(leg.hip_yaw_pitch, axis) * about_x(leg.hip_roll) *
         about_y(leg.hip_pitch) * shift(0, 0, -dimensions_.thigh) * about_y(leg.knee_pitch) *
         shift(0, 0, -dimensions_.tibia) * about_y(leg.ankle_pitch) * about_x(leg.ankle_roll) *
         shift(0, 0, -dimensions_.foot_height);
}

Transform Kinematics::neck_from_camera(Camera camera) const {
  const CameraMount& mount = dimensions_.camera(camera);
  const Calibration::CameraOffset& offset = calibration_.camera(camera);
  Transform axes = Transform::Identity();
  axes.linear() = kForwardLeftUpFromRightDownForward;
  return shift(mount.x, 0, mount.z) * about_z(offset.pan) * about_y(mount.tilt + offset.tilt) * about_x(offset.roll) *
         axes;
}

Transform Kinematics::hip_from_camera(const PerJoint<float>& joints, Camera camera) const {
  return shift(0, 0, dimensions_.hip_to_neck) * about_z(joints[head_yaw]) * about_y(joints[head_pitch]) *
         neck_from_camera(camera);
}

Transform Kinematics::robot_from_hip(const PerJoint<float>& joints, double roll, double pitch) const {
  const Transform upright = about_y(pitch + calibration_.body_pitch) * about_x(roll + calibration_.body_roll);
  const Vector3d left = upright * hip_from_sole(joints, Side::left).translation();
  const Vector3d right = upright * hip_from_sole(joints, Side::right).translation();
  const Vector3d middle = (left + right) / 2;
  return shift(-middle.x(), -middle.y(), -std::min(left.z(), right.z())) * upright;
}

Kinematics::Lean Kinematics::lean_on(const PerJoint<float>& joints, Side side) const {
  const Vector3d up = hip_from_sole(joints, side).linear() * Vector3d::UnitZ();
  return {.roll = std::atan2(up.y(), up.z()), .pitch = -std::atan2(up.x(), std::hypot(up.y(), up.z()))};
}

Side Kinematics::support_foot(const PerJoint<float>& joints, double roll, double pitch) const {
  const Transform robot = robot_from_hip(joints, roll, pitch);
  const double left = (robot * hip_from_sole(joints, Side::left)).translation().z();
  const double right = (robot * hip_from_sole(joints, Side::right)).translation().z();
  return left <= right ? Side::left : Side::right;
}

Kinematics::HeadTurn Kinematics::look_at(const Vector3d& point_in_hip, Camera camera) const {
  const Vector3d point = point_in_hip - Vector3d(0, 0, dimensions_.hip_to_neck);
  const Transform in_head = neck_from_camera(camera);
  const Vector3d eye = in_head.translation(), axis = in_head.linear().col(2);

  // the point of the camera's axis with the same distance from the neck as the target
  const double along = eye.dot(axis);
  const double ahead = std::sqrt(std::max(along * along + point.squaredNorm() - eye.squaredNorm(), 0.0)) - along;
  const Vector3d seen = eye + ahead * axis;

  // a pitch that moves it to the target's height, then a yaw that moves it to the target
  const double reach = std::hypot(seen.x(), seen.z());
  const double height = std::asin(std::clamp(point.z() / reach, -1.0, 1.0));
  return {.yaw = std::remainder(std::atan2(point.y(), point.x()) - std::atan2(seen.y(), reach * std::cos(height)),
                                2 * std::numbers::pi),
          .pitch = std::atan2(seen.z(), seen.x()) - height};
}

}  // namespace robot::nao
