// Where the parts of a Nao are, told by its joints and the lean of its torso.
//
// Frames: `hip` — the middle between the hip joints, +x forward, +y left, +z to the head, turning with the torso;
// `robot` — on the ground in the middle between the feet, turned as the torso is around the vertical, +z up;
// `camera` — right, down, forward; `sole` — under the ankle, on the underside of the foot, axes as the hip's when standing.
#pragma once

#include <Eigen/Geometry>

#include "robot/nao/lola/joints.h"

namespace robot::nao {

using Transform = Eigen::Isometry3d;

enum class Camera { top, bottom };
enum class Side { left, right };

/// Where a camera sits in the head: before and above the neck [m], and how far it looks down [rad].
struct CameraMount {
  double x, z, tilt;
};

/// The lengths of a Nao [m]; those of V4, V5 and V6 are the same (B-Human, HULKs, Aldebaran's documentation).
struct Dimensions {
  double thigh = 0.1, tibia = 0.1029, foot_height = 0.04519;
  double hip_half_width = 0.05;  // from the hip frame to a leg
  double hip_to_neck = 0.2115;
  CameraMount top{.x = 0.05871, .z = 0.06364, .tilt = 0.020944};     // 1.2°
  CameraMount bottom{.x = 0.05071, .z = 0.01774, .tilt = 0.692896};  // 39.7°

  const CameraMount& camera(Camera which) const { return which == Camera::top ? top : bottom; }
};

/// What one robot is off its plan [rad]: measured for each robot, since heads and inertial units are never mounted alike.
struct Calibration {
  struct CameraOffset {
    double roll = 0;  // > 0: the image turns clockwise around its axis
    double tilt = 0;  // > 0: it looks further down
    double pan = 0;   // > 0: it looks further left
  };
  CameraOffset top, bottom;
  double body_roll = 0, body_pitch = 0;  // added to what the inertial unit tells

  const CameraOffset& camera(Camera which) const { return which == Camera::top ? top : bottom; }
};

/// Pure, any thread. `joints` are positions in LoLA's order [rad].
class Kinematics {
 public:
  explicit Kinematics(Calibration calibration = {}, Dimensions dimensions = {})
      : calibration_(calibration), dimensions_(dimensions) {}

  Transform hip_from_sole(const PerJoint<float>& joints, Side side) const;
  Transform hip_from_camera(const PerJoint<float>& joints, Camera camera) const;

  /// With a torso that leans by `roll` and `pitch` [rad], as LoLA's angles have it: the lower foot is on the ground.
  Transform robot_from_hip(const PerJoint<float>& joints, double roll, double pitch) const;

  struct Lean {
    double roll, pitch;  // [rad]
  };

  /// How the torso leans if that foot stands flat on the ground, calibration aside.
  Lean lean_on(const PerJoint<float>& joints, Side side) const;

  /// The foot that is lower.
  Side support_foot(const PerJoint<float>& joints, double roll, double pitch) const;

  struct HeadTurn {
    double yaw, pitch;  // [rad]; may be beyond what the head can
  };

  /// How the head must turn so that `camera` looks straight at `point_in_hip` [m]. A point within the reach of the head
  /// itself, nearer to the neck than a camera can look past, gets the nearest there is.
  HeadTurn look_at(const Eigen::Vector3d& point_in_hip, Camera camera) const;

 private:
  Transform neck_from_camera(Camera camera) const;

  Calibration calibration_;
  Dimensions dimensions_;
};

}  // namespace robot::nao
