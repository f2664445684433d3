// The places where live robots believe to be: they say which robot of the truth is which.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "proto/foresight/game.pb.h"
#include "proto/foresight/pose.pb.h"
#include "robot/app/robot_name.h"
#include "robot/app/truth/truth_writer.h"
#include "robot/memory/channels.h"

namespace robot::app {

/// The objects of a robot that are needed.
inline constexpr const char *kPoseObject = "pose", *kGameObject = "game";

/// Least deviation [m] of an own pose. Its errors last for seconds, and a robot that is surer than this is wrong now and then.
inline constexpr double kLeastPoseDeviation = 0.1;

/// Returns a robot's pose in the frame `field`. Returns nothing while the direction of play is not known, or for numbers
/// that are not finite.
std::optional<truth::OwnPose> own_pose_of(RobotName robot, const foresight::Pose& pose,
                                          const foresight::GameState& game, std::uint64_t capture_ns);

/// Passes the robots' poses on to the tracks. Used by one thread.
class RobotPoses {
 public:
  /// `robots` are channels with the robots' objects by the clock of the truth. Both outlive this.
  RobotPoses(const memory::Channels& robots, TruthWriter& writer) : robots_(robots), writer_(writer) {}

  /// Passes on the newest pose of each robot, if it is new. Called at least ten times a second.
  void pass_on();

 private:
  const memory::Channels& robots_;
  TruthWriter& writer_;
  std::map<std::string, std::uint64_t> passed_;  // by topic: the time of the newest pose [ns since the epoch]
};

}  // namespace robot::app
