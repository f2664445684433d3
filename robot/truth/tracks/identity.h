// The identities of robots: which track is which player.
//
// Evidence is the logarithm of a likelihood ratio. It accumulates with time, not with the count of poses, because the errors
// of a robot's localisation last for seconds. So a short time on the wrong half of the field changes no identity.
#pragma once

#include "robot/truth/tracks/scene.h"

namespace robot::truth {

/// Returns the evidence that a robot at this place is the player with this own pose: at least -3, because own poses may be
/// far off. `shared` is the covariance of the robot's place [m²].
double evidence_of(const OwnPose& pose, const Eigen::Vector2d& position, const Eigen::Matrix2d& covariance);

/// Takes new players into the scene.
void know_players(TrackScene& scene, const OwnPoses& poses);

/// Lets own poses of the scene's time count for `dt` [s], then binds players to robots and releases them.
///
/// A player is bound to a robot with a lead of 6 over all others (400 : 1). It is released when its evidence is gone, or
/// when another robot leads by as much.
void identify(TrackScene& scene, const OwnPoses& poses, double dt);

/// Binds the player at once, because its tag was read on the robot.
void identify_by_tag(TrackScene& scene, std::size_t player, RobotTrack& robot);

/// Releases a robot's player, and keeps little of its evidence: it came out of an occlusion while others are hidden, so it
/// may be another one. Own poses at its place bind it again after a second or two.
void doubt(TrackScene& scene, RobotTrack& robot);

/// Forgets which of two robots is which, because either may have come out of an occlusion at this place. Releases their
/// players until new evidence tells them apart.
void confuse(TrackScene& scene, RobotTrack& one, RobotTrack& other);

/// Returns the index of the player that the robot is, or nothing.
std::optional<std::size_t> player_of(const TrackScene& scene, const RobotTrack& robot);

}  // namespace robot::truth
