// The truth and a robot's beliefs as scenes.
#pragma once

#include <cstdint>
#include <string>

#include "proto/foresight/ball.pb.h"
#include "proto/foresight/game.pb.h"
#include "proto/foresight/motion.pb.h"
#include "proto/foresight/opponents.pb.h"
#include "proto/foresight/pose.pb.h"
#include "proto/foresight/team.pb.h"
#include "proto/foresight/truth.pb.h"
#include "robot/net/scene/scene.h"

namespace robot::net {

/// The looks of both sides, as in our own viewer: the home team's robots are round, the others square.
struct Liveries {
  std::uint32_t home_team = 0;  // number; 0: unknown
  Colour home = colour_of(0x8ec5ff), away = colour_of(0xe8500a);

  bool is_home(std::uint32_t team) const { return team == home_team; }
  const Colour& of(bool home_side) const { return home_side ? home : away; }
};

/// Returns the liveries with the jerseys that the GameController reports. Without two different ones, returns the usual
/// liveries.
Liveries liveries_of(std::uint32_t home_team, const foresight::GameState& game);

/// Returns the ball and the robots as they were. They are opaque.
Scene truth_scene(const foresight::GroundTruth& truth, const Liveries& liveries);

/// The beliefs of one robot. Absent ones are empty messages.
struct Believed {
  std::uint32_t team = 0, player = 0;
  foresight::Pose pose;
  foresight::Ball ball;
  foresight::Team mates;
  foresight::Opponents opponents;
  foresight::GameState game;
  foresight::MotionStatus motion;
};

/// A pose on the ground.
struct GroundPose {
  double x = 0, y = 0, heading = 0;  // [m, rad, field]
};

/// Returns the believed pose in the frame field: team_field is turned by π if the team attacks the other way.
GroundPose pose_in_field(const foresight::Pose& pose, const foresight::GameState& game);

/// Returns the beliefs at `now_ns` in the frame field. They are translucent, and old ones more so.
Scene belief_scene(const Believed& believed, const Liveries& liveries, std::uint64_t now_ns);

}  // namespace robot::net
