// Motions of the whole body as sequences of poses, and their player.
#pragma once

#include <span>

#include "robot/nao/guardian/limiter.h"
#include "robot/nao/lola/joints.h"

namespace robot::nao {

/// Target of the joints at the end of `seconds`.
struct KeyFrame {
  PerJoint<float> position;  // [rad]; hands 0 closed .. 1 open
  float stiffness;           // [0..1] of all joints
  float seconds;             // since the previous pose
  bool needs_feet = false;   // begins only with weight on the feet
};

using KeyFrames = std::span<const KeyFrame>;

// They were computed so that the feet stay flat, the torso upright and the centre of mass above the feet.
// tests/robot/nao/guardian/key_frames_test.cpp checks these laws; no robot has played the motions yet.
KeyFrames stand_up();  // from the pose of a seated robot without stiffness
KeyFrames stand();     // from any upright pose, straight to the stand
KeyFrames sit();       // from the stand to a squat in which calves and thighs carry the robot
KeyFrames tuck();      // in a fall: protects arms and head, with joints that give way

/// Returns the pose in which the robot stands.
const KeyFrame& stand_pose();

/// A player of one motion. Between key frames the joints speed up and slow down smoothly.
class Player {
 public:
  /// Starts `motion` from `start`, the commanded positions of the joints.
  void play(KeyFrames motion, const PerJoint<float>& start);

  /// Returns the pose `dt` [s] later.
  Pose next(float dt);

  bool finished() const { return frame_ >= motion_.size(); }
  float remaining() const;  // [s]

  /// Returns whether the current key frame, or the one that begins next, needs weight on the feet.
  bool needs_feet() const { return !finished() && motion_[frame_].needs_feet; }

 private:
  KeyFrames motion_;
  PerJoint<float> from_{};
  std::size_t frame_ = 0;
  float elapsed_ = 0;  // [s] in this key frame
};

}  // namespace robot::nao
