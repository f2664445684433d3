// The most likely places of ball and robots, with their deviations, from the knowledge of one robot.
#pragma once

#include <cmath>

#include "sim/foresight/situation.h"

namespace sim::foresight {

/// Frame: team_field.
struct BallGuess {
  Vec2 position;                 // [m]
  Vec2 velocity;                 // [m/s]
  float deviation = 0;           // [m] along each axis
  float velocity_deviation = 0;  // [m/s]
  float elsewhere = 0;           // [0..1] probability that it is not there: kicked away, or placed by the referee
  Tick seen = kNever;            // kNever: not seen
  bool by_own_eyes = false;      // true: the error of the own pose comes on top
};

/// Returns whether a place is beyond the middle of a line. Frame: field or team_field.
inline bool beyond_lines(const field::Field& field, Vec2 point) {
  return std::abs(point.x) > field.length / 2 || std::abs(point.y) > field.width / 2;
}

/// Guesses the ball: from the own sight while it is fresh, otherwise from the newest report. The guess is less certain
/// for an older sight, and for a ball that seems to be out.
BallGuess guess_ball(const field::Field& field, const Knowledge& knowledge);

/// Frame: team_field.
struct RobotGuess {
  Pose2 pose;
  float deviation = 0;          // [m] along each axis
  float deviation_heading = 0;  // [rad]
};

/// Guesses a robot: itself by its localisation, a teammate by its message, an opponent by its last sight. An unknown
/// robot is where its side usually stands while the ball is at `ball`.
RobotGuess guess_robot(const Params& params, const Knowledge& knowledge, Vec2 ball, int robot);

}  // namespace sim::foresight
