// The last gate before the joints.
#pragma once

#include "robot/nao/lola/joints.h"

namespace robot::nao {

struct Pose {
  PerJoint<float> position{};   // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};  // [0..1]
};

/// Whatever is asked for: no joint goes beyond its range or its speed, the head never meets the shoulders, and stiffness
/// grows slowly. It falls at once. A joint without stiffness is commanded to where it is, so that it never jumps when it
/// gets some. What is no number is not obeyed.
class Limiter {
 public:
  static constexpr float kStiffnessRise = 2;  // [1/s]

  /// What the joints had before we came.
  void start(const Pose& pose);

  /// The next pose on the way to `target`, `dt` [s] after the last one, with that share of the joints' speed (0..1].
  /// `measured` are the joints now [rad].
  const Pose& next(const Pose& target, const PerJoint<float>& measured, float dt, float speed_share);

  /// All joints without stiffness.
  const Pose& soften(const PerJoint<float>& measured);

  const Pose& pose() const { return pose_; }

 private:
  Pose pose_;
};

}  // namespace robot::nao
