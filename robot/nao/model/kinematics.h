// Kinematics of a Nao: the poses of its parts from its joints and the lean of its torso.
//
// Frames:
// - `hip`: the middle between the hip joints, +x forward, +y left, +z to the head. It turns with the torso.
// - `robot`: on the ground in the middle between the feet, +z up. It has the torso's direction around the vertical.
// - `camera`: +x right, +y down, +z forward.
// - `sole`: under the ankle, on the underside of the foot. Its axes equal the hip's when standing.
#pragma once

#include <Eigen/Geometry>

#include "robot/nao/lola/joints.h"
#include "robot/nao/model/dimensions.h"

namespace robot::nao {

using Transform = Eigen::Isometry3d;

enum class Side { left, right };

/// Offsets of one robot from the model [rad], measured for each robot: heads and inertial units are never mounted
/// alike.
struct Calibration {
  struct CameraOffset {
    double roll = 0;  // > 0: the image turns clockwise around its axis
    double tilt = 0;  // > 0: it looks further down
    double pan = 0;   // > 0: it looks further left
  };
  CameraOffset top, bottom;
  double body_roll = 0, body_pitch = 0;  // added to the angles of the inertial unit

  const CameraOffset& camera(Camera which) const { return which == Camera::top ? top : bottom; }
};

/// The kinematics of one robot. Pure, any thread. `joints` are positions in LoLA's order [rad].
class Kinematics {
 public:
  explicit Kinematics(Calibration calibration = {}, Dimensions dimensions = {})
      : calibration_(calibration), dimensions_(dimensions) {}

  Transform hip_from_sole(const PerJoint<float>& joints, Side side) const;
  Transform hip_from_camera(const PerJoint<float>& joints, Camera camera) const;

  /// Returns the pose of the hip for a torso that leans by `roll` and `pitch` [rad], as in LoLA's angles. The lower
  /// foot is on the ground.
  Transform robot_from_hip(const PerJoint<float>& joints, double roll, double pitch) const;

  struct Lean {
    double roll, pitch;  // [rad]
  };

  /// Returns the lean of the torso if that foot is flat on the ground, without calibration.
  Lean lean_on(const PerJoint<float>& joints, Side side) const;

  /// Returns the lower foot.
  Side support_foot(const PerJoint<float>& joints, double roll, double pitch) const;

  struct HeadTurn {
    double yaw, pitch;  // [rad]; may be outside the range of the head
  };

  /// Returns the turn of the head with which `camera` looks straight at `point_in_hip` [m]. If the point is so near the
  /// neck that this is impossible, returns the nearest solution.
  HeadTurn look_at(const Eigen::Vector3d& point_in_hip, Camera camera) const;

 private:
  Transform neck_from_camera(Camera camera) const;

  Calibration calibration_;
  Dimensions dimensions_;
};

}  // namespace robot::nao
