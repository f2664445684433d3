// Limits of all joint commands, applied last.
#pragma once

#include "robot/nao/lola/joints.h"

namespace robot::nao {

/// Positions and stiffness of all joints.
struct Pose {
  PerJoint<float> position{};   // [rad]; hands 0 closed .. 1 open
  PerJoint<float> stiffness{};  // [0..1]
};

/// The limiter of joint commands. No joint exceeds its range or its speed, and the head never touches the shoulders.
/// Stiffness rises slowly and falls at once. A joint without stiffness is commanded to its measured position, so that
/// it never jumps when it gets stiffness. Targets that are not finite are ignored.
class Limiter {
 public:
  static constexpr float kStiffnessRise = 2;  // [1/s]

  /// Sets the pose that the joints had before the guardian started.
  void start(const Pose& pose);

  /// Returns the next pose on the way to `target`, `dt` [s] after the last one. The joints use `speed_share` (0..1] of
  /// their speed. `measured` are the positions now [rad].
  const Pose& next(const Pose& target, const PerJoint<float>& measured, float dt, float speed_share);

  /// Returns the pose in which no joint has stiffness.
  const Pose& soften(const PerJoint<float>& measured);

  const Pose& pose() const { return pose_; }

 private:
  Pose pose_;
};

}  // namespace robot::nao
