// Motions of the whole body as poses one after the other: data, and what plays them.
#pragma once

#include <span>

#include "robot/nao/guardian/limiter.h"
#include "robot/nao/lola/joints.h"

namespace robot::nao {

/// Where the joints shall be at the end of `seconds`.
struct KeyFrame {
  PerJoint<float> position;  // [rad]; hands 0 closed .. 1 open
  float stiffness;           // [0..1] of all joints
  float seconds;             // from the pose before
  bool needs_feet = false;   // begins only with weight on the feet
};

using KeyFrames = std::span<const KeyFrame>;

// They were computed so that the feet stay flat, the torso upright and the centre of mass above the feet, and proved by
// the laws of tests/robot/nao/guardian/key_frames_test.cpp; no robot has played them yet.
KeyFrames stand_up();  // from where a seated robot lies soft
KeyFrames stand();     // from any upright pose, straight to the stand
KeyFrames sit();       // from the stand to a squat in which calves and thighs carry the robot
KeyFrames tuck();      // in a fall: arms and head where they break least, joints that give way

/// The pose in which the robot stands.
const KeyFrame& stand_pose();

/// Plays one motion; between key frames the joints gain and lose speed smoothly.
class Player {
 public:
  /// From `start`, where the joints are commanded to.
  void play(KeyFrames motion, const PerJoint<float>& start);

  /// The pose `dt` [s] later.
  Pose next(float dt);

  bool finished() const { return frame_ >= motion_.size(); }
  float remaining() const;  // [s]

  /// Whether the key frame it is in, or about to begin, needs weight on the feet.
  bool needs_feet() const { return !finished() && motion_[frame_].needs_feet; }

 private:
  KeyFrames motion_;
  PerJoint<float> from_{};
  std::size_t frame_ = 0;
  float elapsed_ = 0;  // [s] in this key frame
};

}  // namespace robot::nao
