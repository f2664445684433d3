// Motions of the whole body as sequences of poses, and their player.
#pragma once

#include <algorithm>
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
  Range pitch{-4, 4};        // [rad] of the torso while it is played; the motion is broken off outside
};

using KeyFrames = std::span<const KeyFrame>;

// They were computed so that the feet stay flat, the torso upright and the centre of mass above the feet.
// tests/robot/nao/guardian/key_frames_test.cpp checks these laws; no robot has played the motions yet.
KeyFrames stand_up();  // from the pose of a seated robot without stiffness
KeyFrames stand();     // from any upright pose, straight to the stand
KeyFrames sit();       // from the stand to a squat in which calves and thighs carry the robot
KeyFrames tuck();      // in a fall: protects arms and head, with joints that give way

/// Returns these positions with left and right exchanged [rad].
PerJoint<float> mirrored(const PerJoint<float>& positions);

/// Returns the pose in which the robot stands.
const KeyFrame& stand_pose();

/// A player of one motion. Between key frames the joints speed up and slow down smoothly.
class Player {
 public:
  /// Starts `motion` from `start`, the commanded positions of the joints. It takes `longer` times its durations.
  void play(KeyFrames motion, const PerJoint<float>& start, float longer = 1);

  /// Returns the pose `dt` [s] later.
  Pose next(float dt);

  /// Returns the key frame that is played, or the last one.
  const KeyFrame& frame() const { return motion_[std::min(frame_, motion_.size() - 1)]; }

  bool finished() const { return frame_ >= motion_.size(); }
  float remaining() const;  // [s]

  /// Returns whether the current key frame, or the one that begins next, needs weight on the feet.
  bool needs_feet() const { return !finished() && motion_[frame_].needs_feet; }

 private:
  KeyFrames motion_;
  PerJoint<float> from_{};
  float longer_ = 1;
  std::size_t frame_ = 0;
  float elapsed_ = 0;  // [s] in this key frame
};

}  // namespace robot::nao
